#include "techniques/maps/translucent_maps.h"

namespace sb {

KnobInfo colourFormatKnob() {
  return {.name = "colour",
          .help = "of the shadow colour",
          .fallback = "rgba16f",
          .choices = {"rgba8", "rgba16f"},
          .sweep = {"rgba8", "rgba16f"}};
}

rhi::Format colourMapFormat(const Knobs& knobs) {
  return knobs.is("colour", "rgba8") ? rhi::Format::RGBA8Unorm : rhi::Format::RGBA16Float;
}

rhi::GraphicsPipelineDesc colourPipeline(const Context& context, const ShadowMaps& maps,
                                         const std::string& fragment, rhi::Format format) {
  rhi::GraphicsPipelineDesc desc = maps.casterPipeline(context, "shadow colour", fragment, false);
  desc.depth = {.test = true, .write = false, .compare = rhi::CompareOp::GreaterOrEqual};
  // Toward the light, by more than two rasterisations of one plane may differ: some half-ulps of
  // depth, and 1/256 of a texel along the slope on either side.
  desc.raster.depthBiasConstant = maps.depthFormat() == rhi::Format::D32Float ? 16.0f : 2.0f;
  desc.raster.depthBiasSlope = 1.0f / 32.0f;
  desc.targets = {{.format = format,
                   .blend = {.enabled = true,
                             .srcColor = rhi::BlendFactor::Zero,
                             .dstColor = rhi::BlendFactor::SrcColor,
                             .srcAlpha = rhi::BlendFactor::Zero,
                             .dstAlpha = rhi::BlendFactor::One}}};
  return desc;
}

void recordColourPass(Frame& frame, const ShadowMaps& maps, const LightView& view,
                      rhi::TextureId colour, uint32_t layer,
                      const std::function<void(rhi::CommandList&)>& body, rhi::LoadOp load) {
  rhi::DepthAttachment depth = maps.depthAttachment(view);
  depth.load = rhi::LoadOp::Load;
  depth.readOnly = true;
  rhi::ColorAttachment target{.view = depth.view, .load = load, .clear = {1, 1, 1, 1}};
  target.view.texture = colour;
  target.view.baseLayer = layer;
  frame.pass({.label = "shadow colour", .colors = std::span(&target, 1), .depth = depth},
             PassGroup::Shadow, body);
}

}  // namespace sb
