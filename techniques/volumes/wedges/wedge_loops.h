// Soft shadows loop by loop (thesis of the third source document, section 4.4; spec 08, PER_LOOP):
// PenumbraWedge's combine=loop. A loop's volume and all of its wedges are drawn into a buffer of
// its own, in which each edge says on which side of it the light's centre lies; so no pixel near a
// hard edge is seen in two ways. Right for loops that are convex before the light. Two passes a
// loop, one draw for its wedges.
#pragma once

#include "techniques/volumes/wedges/soft_shadows.h"

namespace sb {

class WedgeLoops final : public SoftShadows {
 public:
  using SoftShadows::SoftShadows;
  void prepare(const ShadowVolumes& volumes, const std::vector<LightVolumes>& lights,
               const ShadowMask& mask) override;
  void record(const SoftLight& light) const override;

 private:
  /// A loop of a caster, with its wedges.
  void recordLoop(const SoftLight& light, const CasterVolume& caster, const SilhouetteLoop& loop,
                  const WedgeRange& wedges) const;
  /// What it hides is taken off the slot; `first`: of what is taken off it.
  void recordTransfer(const SoftLight& light, bool first) const;

  std::optional<VolumeCounter> m_counter;
  /// Red: of its volume; green: edges with the light's centre outside; blue: edges that cross the
  /// light; alpha: what they hide.
  rhi::TextureId m_loop{};
  rhi::PipelineId m_wedgePipeline;
  std::vector<rhi::PipelineId> m_transferPipelines;  ///< by channel
};

}  // namespace sb
