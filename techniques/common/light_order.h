// Translucent casters in the order in which a light meets them, for blending that does not commute.
#pragma once

#include "techniques/common/shadow_maps.h"
#include "techniques/common/triangle_order.h"

namespace sb {

/// Knob `order`: what is sorted front to back from the light, and by what.
KnobInfo lightOrderKnob();

/// The casters of one view in order: whole instances or triangles.
class LightOrder {
 public:
  std::vector<uint32_t> instances;
  TriangleOrder triangles;
  bool byTriangle = false;

  void draw(rhi::CommandList& commands, DrawList& whole, rhi::PipelineId pipeline);
};

/// One order a view. `how`: a value of the knob.
std::vector<LightOrder> lightOrder(const Context& context, const ShadowMaps& maps,
                                   const std::string& how);

/// Distance from the light of a camera-relative point, world units: along the direction of a
/// directional light (from any origin), along the axis of a projected face otherwise.
double lightDepth(const LightView& view, const glm::dvec3& relative);

}  // namespace sb
