#include "techniques/volumes/wedges/wedge_halves.h"

#include "shaders/common/shared_slots.h"
#include "techniques/render/camera_pass.h"
#include "techniques/render/screen_targets.h"

namespace sb {

using rhi::StencilOp;

void WedgeHalves::prepare(const ShadowVolumes& volumes, const std::vector<LightVolumes>& lights,
                          const ShadowMask& mask) {
  const Context& context = m_context;
  const rhi::Format format =
      context.knobs.is("format", "r16f") ? rhi::Format::R16Float : rhi::Format::R32Float;
  m_counter.emplace(context, CounterKind::Float, VolumeFaces::Both, format);
  m_counter->prepare(volumes, lights);
  m_hidden = context.transients.texture(screenTarget(context, "penumbra shares", format),
                                        FramePart::Receivers);
  for (const bool inner : {false, true}) prepareHalf(inner, format);
  rhi::GraphicsPipelineDesc whole = wedgePipeline(shader("wedge"), format);
  whole.constants = {{16, SUMS_TOGETHER}};
  m_whole = context.pipeline(whole);
  for (uint32_t channel = 0; channel < mask.channels(); ++channel)
    m_maskPipelines.push_back(
        context.pipeline({.label = "penumbra mask",
                          .vertex = &context.shaders.get("common/fullscreen.vert"),
                          .fragment = &context.shaders.get("penumbra_wedge/mask.frag"),
                          .constants = {{16, SUMS_TOGETHER}, {17, false}},
                          .targets = {mask.target(channel)}}));
}

void WedgeHalves::prepareHalf(bool inner, rhi::Format format) {
  rhi::GraphicsPipelineDesc desc = wedgePipeline(shader("wedge_half"), format);
  desc.vertex = &m_context.shaders.get("penumbra_wedge/wedge_half.vert");
  desc.constants = {{16, inner}};
  desc.raster.cull = rhi::CullMode::None;
  // Once for each receiver that is marked, which is marked no more.
  rhi::GraphicsPipelineDesc adds = desc;
  adds.depth = {};
  const rhi::StencilFace marked{.compare = rhi::CompareOp::NotEqual, .pass = StencilOp::Zero};
  adds.stencil = {.test = true, .front = marked, .back = marked};
  // Counted behind the receiver, as volumes are: wherever the eye is.
  desc.fragment = nullptr;
  desc.targets[0].writeMask = 0;
  desc.depth = {.test = true, .compare = VolumeCounter::kBefore};
  desc.stencil = {.test = true,
                  .front = {.depthFail = StencilOp::DecrementWrap},
                  .back = {.depthFail = StencilOp::IncrementWrap}};
  m_halves[inner] = {.marks = m_context.pipeline(desc), .adds = m_context.pipeline(adds)};
}

void WedgeHalves::record(const SoftLight& light) const {
  recordSum(light, m_hidden, [&](rhi::CommandList& commands) {
    m_counter->draw(commands, light.volumes, light.light, light.light.casters);
    drawHalves(commands, light);
  });
  recordMask(light);
}

void WedgeHalves::drawHalves(rhi::CommandList& commands, const SoftLight& light) const {
  const std::vector<rhi::Binding> all = bindings(light.layer, light.number);
  const auto draw = [&](rhi::PipelineId pipeline, uint32_t vertices, uint32_t wedge) {
    commands.draw({.pipeline = pipeline, .bindings = all, .scissor = light.light.scissor},
                  {.vertexCount = vertices, .firstVertex = vertices * wedge});
  };
  for (uint32_t i = 0; i < m_wedges.ofLight(light.number).count; ++i) {
    if (!m_wedges.hasHull(light.number, i)) {
      draw(m_whole, WEDGE_VERTICES, i);
      continue;
    }
    for (const Half& half : m_halves) {
      draw(half.marks, WEDGE_HALF_VERTICES, i);
      draw(half.adds, WEDGE_HALF_VERTICES, i);
    }
  }
}

void WedgeHalves::recordMask(const SoftLight& light) const {
  const rhi::ColorAttachment target = light.mask.attachment(light.slot);
  const rhi::ResourceUse reads[] = {rhi::use(light.layer.depth, rhi::Access::Sampled),
                                    rhi::use(m_hidden, rhi::Access::Sampled)};
  std::vector<rhi::Binding> all = bindings(light.layer, light.number);
  all.push_back(rhi::textureAt(TEXTURE_TECHNIQUE + 1, m_hidden, m_sampler));
  light.frame.pass({.label = "shadow mask", .colors = std::span(&target, 1), .reads = reads},
                   PassGroup::Shadow, [&](rhi::CommandList& commands) {
                     drawFullscreen(commands, m_maskPipelines[light.slot % ShadowMask::kChannels],
                                    all);
                   });
}

}  // namespace sb
