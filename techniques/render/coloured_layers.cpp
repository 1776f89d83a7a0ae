#include "techniques/render/coloured_layers.h"

#include "shaders/common/shared_slots.h"
#include "techniques/render/screen_targets.h"

namespace sb {

ColouredLayers::ColouredLayers(const Context& context, const CameraPass& camera) {
  const auto texture = [&](const char* label) {
    return context.device.createTexture(screenTarget(context, label, CameraPass::kColorFormat));
  };
  m_color = texture("coloured layers");
  for (rhi::Texture& through : m_through) through = texture("coloured transmittance");
  m_sampler =
      context.device.createSampler({.label = "coloured layers", .filter = rhi::Filter::Nearest});

  rhi::GraphicsPipelineDesc under = camera.compositePipeline("coloured_layers/under.frag");
  under.targets = {{.format = CameraPass::kColorFormat, .blend = kBlendAdd},
                   {.format = CameraPass::kColorFormat, .blend = kBlendAdd}};
  under.constants = {{32, 0}};
  m_under = context.pipeline(under);
  under.constants = {{32, 1}};
  m_first = context.pipeline(under);
  m_over = context.pipeline(camera.colouredCompositePipeline("coloured_layers/over.frag"));
}

void ColouredLayers::slideUnder(Frame& frame, const ColouredLayer& layer, bool first) {
  const rhi::TextureId before = m_through[m_current];
  m_current = 1 - m_current;
  // The next transmittance is added to nothing.
  const rhi::ColorAttachment colors[] = {
      {.view = {.texture = m_color},
       .load = first ? rhi::LoadOp::Clear : rhi::LoadOp::Load,
       .clear = {0, 0, 0, 0}},
      {.view = {.texture = m_through[m_current]}, .clear = {0, 0, 0, 0}}};
  std::vector<rhi::ResourceUse> reads = {rhi::use(layer.light, rhi::Access::Sampled),
                                         rhi::use(layer.behind, rhi::Access::Sampled)};
  if (!first) reads.push_back(rhi::use(before, rhi::Access::Sampled));
  // The first layer has none before it; what stands in that slot is not read.
  const rhi::Binding bindings[] = {
      rhi::textureAt(TEXTURE_TRANSPARENCY, layer.light, m_sampler),
      rhi::textureAt(TEXTURE_TRANSPARENCY + 1, layer.behind, m_sampler),
      rhi::textureAt(TEXTURE_TRANSPARENCY + 2, first ? layer.behind : before, m_sampler)};
  frame.pass({.label = "slide under", .colors = colors, .reads = reads}, PassGroup::Scene,
             [&](rhi::CommandList& commands) {
               drawFullscreen(commands, first ? m_first : m_under, bindings);
             });
}

void ColouredLayers::composite(Frame& frame, CameraPass& camera,
                               std::span<const rhi::ResourceUse> alsoReads,
                               const std::function<void(rhi::CommandList&)>& body) {
  over(frame, camera, "composite", {m_color, m_through[m_current]}, alsoReads, body);
}

void ColouredLayers::layOver(Frame& frame, CameraPass& camera, const ColouredLayer& layer) {
  over(frame, camera, "lay over", layer, {}, {});
}

void ColouredLayers::over(Frame& frame, CameraPass& camera, const std::string& label,
                          const ColouredLayer& layer, std::span<const rhi::ResourceUse> alsoReads,
                          const std::function<void(rhi::CommandList&)>& body) {
  std::vector<rhi::ResourceUse> reads(alsoReads.begin(), alsoReads.end());
  reads.push_back(rhi::use(layer.light, rhi::Access::Sampled));
  reads.push_back(rhi::use(layer.behind, rhi::Access::Sampled));
  const rhi::Binding bindings[] = {
      rhi::textureAt(TEXTURE_TRANSPARENCY, layer.light, m_sampler),
      rhi::textureAt(TEXTURE_TRANSPARENCY + 1, layer.behind, m_sampler)};
  camera.compositePass(frame, label, reads, [&](rhi::CommandList& commands) {
    drawFullscreen(commands, m_over, bindings);
    if (body) body(commands);
  });
}

}  // namespace sb
