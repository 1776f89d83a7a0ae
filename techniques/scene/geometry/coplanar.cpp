#include "techniques/scene/geometry/coplanar.h"

#include <cmath>

namespace sb {
namespace {

using glm::dvec3;

constexpr double kUlps = 4;

bool within(const Facet& plane, const Facet& facet) {
  const dvec3 n = glm::abs(plane.normal);
  if (n == dvec3(0)) return false;
  const double slack = kUlps * glm::dot(n, plane.ulp + facet.ulp);
  for (const dvec3& corner : facet.corners)
    if (std::abs(heightOver(plane, corner)) > slack) return false;
  return true;
}

}  // namespace

Facet facetOf(const PlacedScene& placed, uint32_t index, uint32_t triangle, const dvec3& origin) {
  const Mesh& mesh = placed.scene().meshes[placed.scene().instances[index].mesh];
  const glm::dmat4& toWorld = placed.toWorld(index);
  const glm::dmat3 linear(toWorld);
  const glm::dmat3 size(glm::abs(linear[0]), glm::abs(linear[1]), glm::abs(linear[2]));
  const dvec3 place(toWorld[3]), translation = place - origin;
  Facet facet{.corners = {}, .normal = dvec3(0), .ulp = dvec3(0)};
  for (size_t c = 0; c < 3; ++c) {
    const dvec3 p(mesh.positions[mesh.indices[3 * triangle + c]]);
    facet.corners[c] = linear * p + translation;
    const dvec3 doubles = glm::abs(place) + glm::abs(translation) + glm::abs(facet.corners[c]);
    facet.ulp = glm::max(facet.ulp, size * glm::abs(p) * 0x1p-23 + doubles * 0x1p-52);
  }
  const dvec3 n = glm::cross(facet.corners[1] - facet.corners[0],
                             facet.corners[2] - facet.corners[0]);
  const double length = glm::length(n);
  if (length > 0) facet.normal = n / length;
  return facet;
}

bool coplanar(const Facet& a, const Facet& b) {
  if (a.normal == dvec3(0) || b.normal == dvec3(0)) return false;
  return within(a, b) || within(b, a);
}

SurfaceOrder surfaceOrder(const Scene& scene, uint32_t instance, uint32_t triangle) {
  const Instance& placed = scene.instances[instance];
  const Mesh& mesh = scene.meshes[placed.mesh];
  return {mesh.key, placed.key, mesh.triangleKeys[triangle]};
}

}  // namespace sb
