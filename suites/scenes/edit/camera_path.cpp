#include "suites/scenes/edit/camera_path.h"

#include <cmath>
#include <numbers>

namespace sb {

std::vector<Camera> cameraPath(const Camera& end, const glm::dvec3& move, double turnDegrees,
                               uint32_t steps) {
  std::vector<Camera> path(steps, end);
  for (uint32_t k = 0; k + 1 < steps; ++k) {
    const double left = 1.0 - double(k) / double(steps - 1);  // of the way
    // Columns of the frame are x, y (up) and z: turning back about y mixes x and z.
    const double angle = -left * turnDegrees * std::numbers::pi / 180;
    const double c = std::cos(angle), s = std::sin(angle);
    const glm::dmat4& m = end.toWorld;
    path[k].toWorld[0] = m[0] * c - m[2] * s;
    path[k].toWorld[2] = m[0] * s + m[2] * c;
    path[k].toWorld[3] = m[3] - glm::dvec4(move * left, 0);
  }
  return path;
}

}  // namespace sb
