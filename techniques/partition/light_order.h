// Translucent casters in the order in which a light meets them, for blending that does not commute.
#pragma once

#include <optional>

#include "techniques/draw/triangle_order.h"
#include "techniques/maps/shadow_maps.h"

namespace sb {

/// Knob `order`: what is sorted front to back from the light, and by what.
KnobInfo lightOrderKnob();

/// The casters of one view in order: whole instances or triangles.
class LightOrder {
 public:
  /// `view`: index into ShadowMaps::views. `how`: a value of the knob. Context and maps must
  /// outlive the order.
  LightOrder(const Context& context, const ShadowMaps& maps, size_t view, const std::string& how);

  /// Whole instances; triangles have no such order.
  const std::vector<uint32_t>& instances() const { return m_instances; }
  /// Anew, after the view has moved.
  void sort(rhi::CommandList& commands);
  void draw(rhi::CommandList& commands, DrawList& whole, rhi::PipelineId pipeline);

 private:
  const LightView& lightView() const { return m_maps->views()[m_index]; }
  void sortInstances();

  const SceneView* m_view;
  const ShadowMaps* m_maps;
  size_t m_index;
  std::string m_how;
  std::vector<uint32_t> m_instances;
  std::optional<TriangleOrder> m_triangles;
};

/// One order a view.
std::vector<LightOrder> lightOrder(const Context& context, const ShadowMaps& maps,
                                   const std::string& how);

/// Distance from the light of a camera-relative point, world units: along the direction of a
/// directional light (from any origin), along the axis of a projected face otherwise.
double lightDepth(const LightView& view, const glm::dvec3& relative);

}  // namespace sb
