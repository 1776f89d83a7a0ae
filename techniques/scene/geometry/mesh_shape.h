// Shapes of meshes that decide what may shadow or cover itself.
#pragma once

#include <optional>

#include "techniques/scene/scene.h"

namespace sb {

/// Points p with dot(normal, p) = offset; a normal of length 0: no plane in particular.
struct Plane {
  glm::dvec3 normal = glm::dvec3(0);
  double offset = 0;
};

/// The plane that all triangles of a mesh lie in, up to rounding of their positions, in mesh space.
/// Such a surface shadows nothing of itself. Nothing for other meshes.
std::optional<Plane> planeOf(const Mesh& mesh);

}  // namespace sb
