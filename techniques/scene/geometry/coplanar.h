// When two triangles lie in one plane: within 4 ulp of the coordinates that define them (spec 16).
// Coordinates are the floats of a mesh, placed by the double matrix of its instance; the distance
// from the eye plays no part but for the rounding of doubles. Coplanar surfaces neither shadow nor
// hide one another; they are layers in the order of `SurfaceOrder`, and of several opaque ones the
// first is the surface.
#pragma once

#include <array>
#include <compare>

#include "techniques/scene/placed_scene.h"

namespace sb {

/// A placed triangle with what its plane is known to.
struct Facet {
  std::array<glm::dvec3, 3> corners;  ///< relative to `origin`
  glm::dvec3 normal;                  ///< unit; 0 for a triangle without area
  glm::dvec3 ulp;                     ///< of its coordinates, by component
};
Facet facetOf(const PlacedScene& placed, uint32_t instance, uint32_t triangle,
              const glm::dvec3& origin);

/// Signed distance of a point from the facet's plane.
inline double heightOver(const Facet& facet, const glm::dvec3& point) {
  return glm::dot(facet.normal, point - facet.corners[0]);
}

/// Do all corners of one lie in the plane of the other? The plane of the larger one is the better
/// known, so either way will do.
bool coplanar(const Facet& a, const Facet& b);

/// Order of surfaces that lie in one plane: persistent keys of mesh, instance and triangle.
struct SurfaceOrder {
  uint32_t mesh = 0, instance = 0, triangle = 0;
  auto operator<=>(const SurfaceOrder&) const = default;
};
SurfaceOrder surfaceOrder(const Scene& scene, uint32_t instance, uint32_t triangle);

}  // namespace sb
