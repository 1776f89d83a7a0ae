// The part of a box that a camera sees: a convex solid, as the polygons around it.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "techniques/scene/camera.h"
#include "techniques/scene/tree/region.h"

namespace sb {

/// Corners of a convex polygon, in order.
using Polygon = std::vector<glm::dvec3>;

/// What of a polygon lies inside of all, about one origin (Sutherland, Hodgman 1974); empty:
/// nothing.
Polygon clipped(Polygon polygon, std::span<const HalfSpace> inside);

/// A frustum by its corners, in the order of frustumCorners().
class Frustum {
 public:
  explicit Frustum(const std::array<glm::dvec3, 8>& corners);
  /// Faces of the solid that box and frustum have in common; none: they have nothing.
  std::vector<Polygon> seenPart(const Box& box) const;

 private:
  std::array<Polygon, 6> m_faces;
  std::array<HalfSpace, 6> m_inside;
};

}  // namespace sb
