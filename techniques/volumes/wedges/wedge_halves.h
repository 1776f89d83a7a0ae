// Soft shadows from halves of wedges (Assarsson, Dougherty, Mounier and Akenine-Moller 2003; thesis
// of the third source document, section 4.3.3; spec 08, SPLIT_HALVES): PenumbraWedge's
// combine=split. Each wedge is split where the volume of the light's centre ends: what lies in the
// half toward the occluder gains light, in the other it loses light, so that count and shares agree
// about every pixel. Which receivers lie in a half the stencil says, one half at a time: four draws
// a wedge.
#pragma once

#include "techniques/volumes/wedges/soft_shadows.h"

namespace sb {

class WedgeHalves final : public SoftShadows {
 public:
  using SoftShadows::SoftShadows;
  void prepare(const ShadowVolumes& volumes, const std::vector<LightVolumes>& lights,
               const ShadowMask& mask) override;
  void record(const SoftLight& light) const override;

 private:
  void prepareHalf(bool inner, rhi::Format format);
  void drawHalves(rhi::CommandList& commands, const SoftLight& light) const;
  void recordMask(const SoftLight& light) const;

  struct Half {
    rhi::PipelineId marks, adds;
  };
  std::optional<VolumeCounter> m_counter;
  rhi::TextureId m_hidden{};
  std::array<Half, 2> m_halves;                  ///< outer, inner
  rhi::PipelineId m_whole;                       ///< of wedges that are drawn everywhere
  std::vector<rhi::PipelineId> m_maskPipelines;  ///< by channel
};

}  // namespace sb
