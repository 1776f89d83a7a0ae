// How lookups compare with a depth map: one exact texel a tap, or the hardware's four, weighed
// bilinearly (where the device filters no depth, four fetches instead; shaders/common/
// depth_compare.glsl); maps of several samples a texel, sample by sample (sample_filter.glsl).
#pragma once

#include "techniques/maps/shadow_maps.h"

namespace sb {

/// Default: one exact texel a tap, which is what techniques that read colours beside depths, or
/// depths in colours, do too. So defaults compare techniques, not filters, and a certificate finds
/// equal weights.
KnobInfo compareKnob();

class DepthCompare {
 public:
  /// By knob compare. Throws rhi::Error when hardware is to compare several samples.
  DepthCompare(const Context& context, const ShadowMaps& maps, uint32_t samples = 1);

  /// The depth map and `constants` with those of the shaders named above. `samplesFolder`: of the
  /// visibility that reads several samples.
  VisibilityInputs inputs(const ShadowMaps& maps, const std::vector<rhi::SpecConstant>& constants,
                          const std::string& samplesFolder = "") const;
  /// Texels that a lookup weighs equally; 0 where they weigh unequally or share a random number
  /// (samples of one texel do).
  uint32_t equalTexels() const { return m_equalTexels; }

 private:
  uint32_t m_samples;
  uint32_t m_equalTexels = 0;
  rhi::Sampler m_sampler;  ///< of one sample a texel
  std::vector<rhi::SpecConstant> m_constants;
};

}  // namespace sb
