#include "techniques/scene/geometry/mesh_shape.h"

#include <algorithm>
#include <cmath>

namespace sb {

std::optional<Plane> planeOf(const Mesh& mesh) {
  Plane plane;
  const auto at = [&](size_t i) { return glm::dvec3(mesh.positions[mesh.indices[i]]); };
  for (size_t t = 0; t + 2 < mesh.indices.size() && plane.normal == glm::dvec3(0); t += 3)
    plane.normal = glm::cross(at(t + 1) - at(t), at(t + 2) - at(t));
  if (plane.normal == glm::dvec3(0)) return plane;
  plane.normal = glm::normalize(plane.normal);
  plane.offset = glm::dot(plane.normal, at(0));
  const double size = glm::length(glm::dvec3(mesh.boundsMax) - glm::dvec3(mesh.boundsMin));
  const bool flat = std::ranges::all_of(mesh.indices, [&](uint32_t i) {
    return std::abs(glm::dot(plane.normal, glm::dvec3(mesh.positions[i]) - at(0))) <= 1e-6 * size;
  });
  return flat ? std::optional(plane) : std::nullopt;
}

}  // namespace sb
