#include "techniques/volumes/volume_counter.h"

namespace sb {
namespace {

using rhi::StencilOp;

/// Depth is 1 near .. 0 far. Volumes before the receiver are strictly before it: a cap that lies on
/// its own surface counts as behind, so that what faces the light is lit.
constexpr rhi::CompareOp kBehind = rhi::CompareOp::LessOrEqual;

}  // namespace

std::vector<rhi::CullMode> VolumeCounter::culls() const {
  if (m_faces == VolumeFaces::Both) return {rhi::CullMode::None};
  return {rhi::CullMode::Back, rhi::CullMode::Front};
}

std::span<const uint32_t> VolumeCounter::capsOf(const CasterVolume& volume, uint32_t part) {
  static constexpr uint32_t kWhole[] = {CAPS_BOTH};
  return part == VOLUME_SIDES ? std::span<const uint32_t>(kWhole) : volume.caps;
}

rhi::GraphicsPipelineDesc VolumeCounter::desc(const ShadowVolumes& volumes,
                                              const Variant& variant) const {
  rhi::GraphicsPipelineDesc desc = volumes.pipeline(variant.part, variant.caps);
  desc.label = "shadow volumes";
  desc.depthFormat = kDepthFormat;
  const bool pass = variant.count == DepthCount::Pass;
  const bool beyond = variant.caps == CAPS_BEYOND;
  // Counted before the receiver, a volume ends at the far plane; behind it, it must not.
  desc.raster = {.cull = variant.cull, .depthClamp = !pass && variant.caps != CAPS_NEAR && !beyond};
  // Faces toward the eye are entered before a receiver and left behind it. Caps that were turned
  // over are drawn as they were wound, to meet their surface's depth: their faces are exchanged.
  const bool frontAdds = pass != (variant.part == VOLUME_TURNED);
  if (m_kind == CounterKind::Float) {
    desc.fragment = &m_context.shaders.get("common/volume_count.frag");
    desc.constants.push_back({18, frontAdds});
    desc.constants.push_back({19, rhi::formatInfo(m_format).kind == rhi::FormatKind::Unorm});
    desc.depth = {.test = true,
                  .compare = beyond ? rhi::CompareOp::Always
                             : pass ? kBefore
                                    : kBehind};
    desc.targets = {{.format = m_format,
                     .blend = {.enabled = true,
                               .dstColor = rhi::BlendFactor::One,
                               .dstAlpha = rhi::BlendFactor::One}}};
  } else {
    const auto face = [&](StencilOp op) {
      return pass || beyond ? rhi::StencilFace{.pass = op} : rhi::StencilFace{.depthFail = op};
    };
    desc.depth = {.test = true, .compare = beyond ? rhi::CompareOp::Always : kBefore};
    desc.stencil = {.test = true,
                    .front = face(frontAdds ? StencilOp::IncrementWrap : StencilOp::DecrementWrap),
                    .back = face(frontAdds ? StencilOp::DecrementWrap : StencilOp::IncrementWrap)};
  }
  return desc;
}

void VolumeCounter::prepare(const ShadowVolumes& volumes, const std::vector<LightVolumes>& lights) {
  const auto make = [&](uint32_t part, DepthCount count, uint32_t caps) {
    for (const rhi::CullMode cull : culls()) {
      const Variant v{part, count, cull, caps};
      if (!m_pipelines.contains(v)) m_pipelines[v] = m_context.pipeline(desc(volumes, v));
    }
  };
  for (const LightVolumes& light : lights)
    for (const CasterVolume& volume : light.casters)
      for (const uint32_t part : volume.parts)
        for (const uint32_t caps : capsOf(volume, part)) make(part, volume.count, caps);
  if (lights.empty() || !m_context.view.isFree()) return;
  // Another eye may stand within a volume, or a caster, or see one cut.
  for (uint32_t part = 0; part < VOLUME_PARTS; ++part) {
    for (const DepthCount count : {DepthCount::Pass, DepthCount::Fail})
      make(part, count, CAPS_BOTH);
    for (const uint32_t caps : {CAPS_NEAR, CAPS_BEYOND, CAPS_FAR})
      if (part != VOLUME_SIDES) make(part, DepthCount::Fail, caps);
  }
}

void VolumeCounter::draw(rhi::CommandList& commands, const ShadowVolumes& volumes,
                         const LightVolumes& light, std::span<const CasterVolume> casters,
                         const SilhouetteLoop* loop) const {
  for (const rhi::CullMode cull : culls())
    for (const CasterVolume& volume : casters)
      for (const uint32_t part : volume.parts)
        for (const uint32_t caps : capsOf(volume, part))
          volumes.draw(commands, m_pipelines.at({part, volume.count, cull, caps}), light, volume,
                       part, loop);
}

}  // namespace sb
