// Which translucent surfaces lie before which, as a light sees them: the light-space overlap graph
// of spec 05, at the granularity of instances.
#pragma once

#include <optional>

#include "techniques/draw/views/scene_view.h"
#include "techniques/scene/geometry/hull2.h"
#include "techniques/scene/geometry/mesh_shape.h"

namespace sb {

/// A translucent caster or receiver in one light view. Camera-relative.
struct LightNode {
  uint32_t instance = 0;
  bool casts = false;
  bool receives = false;                ///< in view, and light shows on it
  std::vector<glm::dvec2> hull;         ///< outline on the map, clip coordinates
  double nearest = 0, farthest = 0;     ///< from the light, see lightDepth
  std::array<glm::dvec3, 8> corners{};  ///< of the mesh's box
  std::optional<Plane> plane;           ///< of flat meshes
  /// Not flat: may lie in its own shadow.
  bool mayShadowItself() const { return casts && receives && !plane; }
};

struct LightOverlap {
  std::vector<LightNode> nodes;  ///< in scene order
  /// successors[a]: nodes that `a` lies before, where one may shadow the other. Both ways for pairs
  /// that no plane separates.
  std::vector<std::vector<uint32_t>> successors;
};

/// Nodes are the view's translucent casters and all visible translucent surfaces. Two are related
/// when their outlines overlap on the map and one casts on what the other receives; a lies before b
/// when it is nearer everywhere, or a plane (of one of them if flat, or along a side of their
/// boxes) has the light and a on one side and b on the other. What lies in one plane is unrelated.
LightOverlap lightOverlap(const SceneView& view, const LightView& light);

}  // namespace sb
