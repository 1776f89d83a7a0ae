// Stochastic transparency with a weight per channel (Effect::ColouredTransparency): a channel's
// samples keep the nearest fragment that hides them there, so that a fragment is seen, in
// expectation, through the product of the weights before it. Depths are those of pixel centres in
// all samples: one RGBA32F target a sample, MIN blended; then light and what hides are added up in
// one pass over the surfaces.
//   basic      light as it comes, over the share of the picture that no sample hides: unbiased
//   corrected  scaled by the exact total of each channel: less noise, a small bias
#pragma once

#include "techniques/render/camera_pass.h"

namespace sb {

class ColouredStochastic {
 public:
  ColouredStochastic(const Context& context, const CameraPass& camera, uint32_t samples,
                     bool basic);
  void record(Frame& frame, CameraPass& camera);

 private:
  void createTargets(const Context& context);
  void createPipelines(const Context& context, const CameraPass& camera);
  /// The target of a sample, or of the first one where there are fewer: bound, not read.
  rhi::TextureId depths(size_t sample) const {
    return m_depths[sample < m_samples ? sample : 0];
  }

  uint32_t m_samples;
  bool m_basic;
  rhi::TextureId m_depths[4], m_total, m_light, m_hides;
  rhi::Sampler m_sampler;
  rhi::PipelineId m_totalPass, m_depthPass, m_lightPass, m_composite;
  DrawList m_unshaded, m_shaded;
};

}  // namespace sb
