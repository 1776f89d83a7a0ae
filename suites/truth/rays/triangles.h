// The scene's triangles as rays meet them: relative to the eye, in double, in scene order.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "techniques/scene/scene.h"

namespace sb {

struct TruthTriangle {
  std::array<glm::dvec3, 3> corners;
  uint32_t instance = 0;
  uint32_t number = 0;  ///< in its mesh
};

/// All triangles of all instances; `eye` is subtracted in double.
std::vector<TruthTriangle> truthTriangles(const Scene& scene, const glm::dvec3& eye);

}  // namespace sb
