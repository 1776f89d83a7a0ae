#include "techniques/volumes/wedges/wedge_loops.h"

#include "shaders/common/shared_slots.h"
#include "techniques/render/camera_pass.h"
#include "techniques/render/screen_targets.h"

namespace sb {

void WedgeLoops::prepare(const ShadowVolumes& volumes, const std::vector<LightVolumes>& lights,
                         const ShadowMask& mask) {
  const rhi::Format format =
      m_context.knobs.is("format", "r16f") ? rhi::Format::RGBA16Float : rhi::Format::RGBA32Float;
  m_counter.emplace(m_context, CounterKind::Float, VolumeFaces::Both, format);
  m_counter->prepare(volumes, lights);
  m_loop = m_context.transients.texture(screenTarget(m_context, "penumbra loop", format),
                                        FramePart::Receivers);
  m_wedgePipeline = m_context.pipeline(wedgePipeline(shader("wedge_loop"), format));
  for (uint32_t channel = 0; channel < mask.channels(); ++channel) {
    rhi::ColorTargetState target = mask.target(channel);
    target.blend = kBlendTake;
    m_transferPipelines.push_back(
        m_context.pipeline({.label = "penumbra transfer",
                            .vertex = &m_context.shaders.get("common/fullscreen.vert"),
                            .fragment = &m_context.shaders.get("penumbra_wedge/loop.frag"),
                            .targets = {target}}));
  }
}

void WedgeLoops::record(const SoftLight& light) const {
  bool first = true;
  for (size_t i = 0; i < light.light.casters.size(); ++i) {
    const CasterVolume& caster = light.light.casters[i];
    const std::span<const SilhouetteLoop> loops = light.volumes.loops(caster);
    for (size_t k = 0; k < loops.size(); ++k) {
      recordLoop(light, caster, loops[k], m_wedges.ofLoops(light.number, i)[k]);
      recordTransfer(light, first);
      first = false;
    }
  }
  if (!first) return;
  // Nothing casts: the slot is lit.
  const rhi::ColorAttachment target = light.mask.attachment(light.slot);
  light.frame.pass({.label = "shadow mask", .colors = std::span(&target, 1)}, PassGroup::Shadow,
                   [](rhi::CommandList&) {});
}

void WedgeLoops::recordLoop(const SoftLight& light, const CasterVolume& caster,
                            const SilhouetteLoop& loop, const WedgeRange& wedges) const {
  recordSum(light, m_loop, [&](rhi::CommandList& commands) {
    m_counter->draw(commands, light.volumes, light.light, {&caster, 1}, &loop);
    drawWedges(commands, m_wedgePipeline, light, wedges);
  });
}

void WedgeLoops::recordTransfer(const SoftLight& light, bool first) const {
  rhi::ColorAttachment target = light.mask.attachment(light.slot);
  if (!first) target.load = rhi::LoadOp::Load;
  const rhi::ResourceUse loop = rhi::use(m_loop, rhi::Access::Sampled);
  const rhi::Binding binding = rhi::textureAt(TEXTURE_TECHNIQUE, m_loop, m_sampler);
  light.frame.pass({.label = "shadow mask", .colors = std::span(&target, 1), .reads = {&loop, 1}},
                   PassGroup::Shadow, [&](rhi::CommandList& commands) {
                     drawFullscreen(commands,
                                    m_transferPipelines[light.slot % ShadowMask::kChannels],
                                    {&binding, 1});
                   });
}

}  // namespace sb
