#include "techniques/volumes/wedges/wedge_sums.h"

#include <bit>

#include "shaders/common/shared_slots.h"
#include "techniques/render/camera_pass.h"
#include "techniques/render/screen_targets.h"

namespace sb {

using rhi::Format;

WedgeSums::WedgeSums(const Context& context, const LightWedges& wedges)
    : SoftShadows(context, wedges),
      m_wrap(context.knobs.is("combine", "wrap")),
      m_exact(context.knobs.is("combine", "exact")) {
  if (!m_exact)
    m_sums = context.knobs.is("format", "rgba8")     ? SUMS_BYTES
             : context.knobs.is("combine", "shader") ? SUMS_APART
                                                     : SUMS_TOGETHER;
}

void WedgeSums::prepare(const ShadowVolumes& volumes, const std::vector<LightVolumes>& lights,
                        const ShadowMask& mask) {
  const Context& context = m_context;
  if (!m_exact) {
    const bool apart = m_sums == SUMS_APART;
    const Format target =
        format(apart ? Format::RGBA32Float : Format::R32Float,
               apart ? Format::RGBA16Float : Format::R16Float, Format::RGBA8Unorm);
    m_counter.emplace(context, CounterKind::Float, VolumeFaces::Both, target);
    m_counter->prepare(volumes, lights);
    m_hidden = context.transients.texture(screenTarget(context, "penumbra shares", target),
                                          FramePart::Receivers);
    rhi::GraphicsPipelineDesc wedges = wedgePipeline(shader("wedge"), target);
    wedges.constants = {{16, m_sums}};
    m_wedgePipeline = context.pipeline(wedges);
  }
  const bool exactly = m_exact || context.knobs.is("combine", "shader");
  // Half a step of sums in bytes; what rounding leaves in sums of many edges.
  const float least = context.knobs.is("format", "rgba8")  ? 0.5f / 32
                      : context.knobs.is("format", "r16f") ? 1e-3f
                                                           : 1e-4f;
  for (uint32_t channel = 0; channel < mask.channels(); ++channel) {
    rhi::ColorTargetState target = mask.target(channel);
    if (m_wrap) target.blend = kBlendTake;
    m_maskPipelines.push_back(context.pipeline(
        {.label = "penumbra mask",
         .vertex = &context.shaders.get("common/fullscreen.vert"),
         .fragment = shader("mask"),
         .constants =
             {{16, m_sums}, {17, exactly}, {18, m_wrap}, {19, std::bit_cast<uint32_t>(least)}},
         .targets = {target}}));
  }
}

void WedgeSums::record(const SoftLight& light) const {
  const std::span<const CasterVolume> casters = light.light.casters;
  if (!m_wrap) {
    if (!m_exact) recordSums(light, casters, m_wedges.ofLight(light.number));
    return recordMask(light, true);
  }
  for (size_t i = 0; i < casters.size(); ++i) {
    recordSums(light, casters.subspan(i, 1), m_wedges.ofCaster(light.number, i));
    recordMask(light, i == 0);
  }
}

void WedgeSums::recordSums(const SoftLight& light, std::span<const CasterVolume> casters,
                           const WedgeRange& wedges) const {
  recordSum(light, m_hidden, [&](rhi::CommandList& commands) {
    m_counter->draw(commands, light.volumes, light.light, casters);
    drawWedges(commands, m_wedgePipeline, light, wedges);
  });
}

void WedgeSums::recordMask(const SoftLight& light, bool first) const {
  rhi::ColorAttachment target = light.mask.attachment(light.slot);
  if (!first) target.load = rhi::LoadOp::Load;
  const rhi::TextureId depth = light.layer.depth;
  std::vector<rhi::ResourceUse> reads = {rhi::use(depth, rhi::Access::Sampled)};
  if (!m_exact) reads.push_back(rhi::use(m_hidden, rhi::Access::Sampled));
  std::vector<rhi::Binding> all = bindings(light.layer, light.number);
  // Where nothing is summed nothing reads it.
  all.push_back(rhi::textureAt(TEXTURE_TECHNIQUE + 1, m_exact ? depth : m_hidden, m_sampler));
  light.frame.pass({.label = "shadow mask", .colors = std::span(&target, 1), .reads = reads},
                   PassGroup::Shadow, [&](rhi::CommandList& commands) {
                     drawFullscreen(commands, m_maskPipelines[light.slot % ShadowMask::kChannels],
                                    all);
                   });
}

}  // namespace sb
