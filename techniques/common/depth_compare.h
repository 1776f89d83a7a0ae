// How lookups compare with a depth map (shaders/common/depth_compare.glsl): one exact texel a tap,
// or the hardware's four, weighed bilinearly; where the device filters no depth, four fetches
// instead.
#pragma once

#include "techniques/common/shadow_maps.h"

namespace sb {

KnobInfo compareKnob(const std::string& fallback);

class DepthCompare {
 public:
  /// By knob compare.
  DepthCompare(const Context& context, const ShadowMaps& maps);

  /// Bindings of the depth map for both ways.
  std::vector<rhi::Binding> bindings(const ShadowMaps& maps) const;
  /// Constants 19 and 20 of depth_compare.glsl.
  const std::vector<rhi::SpecConstant>& constants() const { return m_constants; }

 private:
  rhi::Sampler m_sampler;
  std::vector<rhi::SpecConstant> m_constants;
};

}  // namespace sb
