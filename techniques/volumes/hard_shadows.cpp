#include "techniques/volumes/hard_shadows.h"

#include <algorithm>

#include "shaders/common/shared_slots.h"
#include "shaders/common/shared_types.h"
#include "techniques/render/camera_pass.h"
#include "techniques/render/screen_targets.h"

namespace sb {

std::vector<uint32_t> maskSlots(const SceneView& view, const std::vector<LightVolumes>& lights) {
  std::vector<uint32_t> slots;
  for (const LightEffects& light : view.effects().lights) {
    if (!light.touchesView) continue;
    const auto at = std::ranges::find(lights, light.light, &LightVolumes::light);
    slots.push_back(at == lights.end() ? NO_SHADOW : uint32_t(at - lights.begin()));
  }
  return slots;
}

void HardShadows::prepare(const ShadowVolumes& volumes, const std::vector<LightVolumes>& lights,
                          const ShadowMask& mask) {
  m_counter.prepare(volumes, lights);
  const bool floats = m_kind == CounterKind::Float;
  if (floats) {
    m_counts = m_context.transients.texture(
        screenTarget(m_context, "shadow volume counts", VolumeCounter::kFloatFormat),
        FramePart::Receivers);
    m_sampler = m_context.device.createSampler(
        {.label = "shadow volume sampler", .filter = rhi::Filter::Nearest});
  }
  const rhi::StencilFace counted = {.compare = rhi::CompareOp::NotEqual};
  for (uint32_t channel = 0; channel < mask.channels(); ++channel) {
    rhi::GraphicsPipelineDesc desc{
        .label = "shadow mask",
        .vertex = &m_context.shaders.get("common/fullscreen.vert"),
        .fragment = &m_context.shaders.get(floats ? "common/volume_counted.frag"
                                                  : "common/volume_shadowed.frag"),
        .targets = {mask.target(channel)}};
    if (!floats) {
      desc.stencil = {.test = true, .front = counted, .back = counted};
      desc.depthFormat = VolumeCounter::kDepthFormat;
    }
    m_maskPipelines.push_back(m_context.pipeline(desc));
  }
}

void HardShadows::record(Frame& frame, const ReceiverLayer& layer, const ShadowVolumes& volumes,
                         std::span<const LightVolumes> lights, const ShadowMask& mask,
                         uint32_t slot) const {
  recordVolumes(frame, layer, volumes, lights);
  recordMask(frame, layer, mask, slot);
}

void HardShadows::recordVolumes(Frame& frame, const ReceiverLayer& layer,
                                const ShadowVolumes& volumes,
                                std::span<const LightVolumes> lights) const {
  const rhi::ColorAttachment counts{.view = {.texture = m_counts}};
  const std::vector<rhi::ResourceUse> reads = volumes.reads();
  frame.pass({.label = "shadow volumes",
              .colors = std::span(&counts, m_kind == CounterKind::Float ? 1 : 0),
              .depth = rhi::DepthAttachment{.view = {.texture = layer.depth},
                                            .load = rhi::LoadOp::Load,
                                            .readOnly = true},
              .reads = reads},
             PassGroup::Shadow, [&](rhi::CommandList& commands) {
               for (const LightVolumes& light : lights)
                 m_counter.draw(commands, volumes, light, light.casters);
             });
}

void HardShadows::recordMask(Frame& frame, const ReceiverLayer& layer, const ShadowMask& mask,
                             uint32_t slot) const {
  const rhi::ColorAttachment target = mask.attachment(slot);
  rhi::PassDesc pass{.label = "shadow mask", .colors = std::span(&target, 1)};
  const rhi::ResourceUse counts = rhi::use(m_counts, rhi::Access::Sampled);
  std::vector<rhi::Binding> bindings;
  if (m_kind == CounterKind::Float) {
    pass.reads = {&counts, 1};
    bindings = {rhi::textureAt(TEXTURE_TECHNIQUE, m_counts, m_sampler)};
  } else {
    pass.depth = rhi::DepthAttachment{.view = {.texture = layer.depth},
                                      .load = rhi::LoadOp::Load,
                                      .readOnly = true,
                                      .stencilLoad = rhi::LoadOp::Load,
                                      .stencilReadOnly = true};
  }
  frame.pass(pass, PassGroup::Shadow, [&](rhi::CommandList& commands) {
    drawFullscreen(commands, m_maskPipelines[slot % ShadowMask::kChannels], bindings);
  });
}

}  // namespace sb
