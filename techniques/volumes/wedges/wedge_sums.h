// Soft shadows from sums over all volumes and wedges of a light, or of a caster (spec 08,
// FLOAT_SIGNED, and REFERENCE_TILE without sums): PenumbraWedge's combine=shader, float, wrap,
// exact. Two passes a light, all wedges in one draw; wrap: two a caster; exact: one.
#pragma once

#include "techniques/volumes/wedges/soft_shadows.h"

namespace sb {

class WedgeSums final : public SoftShadows {
 public:
  WedgeSums(const Context& context, const LightWedges& wedges);
  void prepare(const ShadowVolumes& volumes, const std::vector<LightVolumes>& lights,
               const ShadowMask& mask) override;
  void record(const SoftLight& light) const override;

 private:
  /// `casters`: of the light; `wedges`: theirs.
  void recordSums(const SoftLight& light, std::span<const CasterVolume> casters,
                  const WedgeRange& wedges) const;
  /// `first`: of what goes into the slot.
  void recordMask(const SoftLight& light, bool first) const;

  const bool m_wrap, m_exact;
  uint32_t m_sums = SUMS_NONE;  ///< SUMS_*
  std::optional<VolumeCounter> m_counter;
  rhi::TextureId m_hidden{};  ///< what SUMS_* says
  rhi::PipelineId m_wedgePipeline;
  std::vector<rhi::PipelineId> m_maskPipelines;  ///< by channel
};

}  // namespace sb
