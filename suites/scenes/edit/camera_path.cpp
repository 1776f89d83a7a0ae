#include "suites/scenes/edit/camera_path.h"

#include <cmath>
#include <numbers>

namespace sb {

std::vector<glm::dmat4> cameraPath(const glm::dmat4& end, const glm::dvec3& move,
                                   double turnDegrees, uint32_t steps) {
  std::vector<glm::dmat4> path(steps, end);
  for (uint32_t k = 0; k + 1 < steps; ++k) {
    const double left = 1.0 - double(k) / double(steps - 1);  // of the way
    // Columns of the frame are x, y (up) and z: turning back about y mixes x and z.
    const double angle = -left * turnDegrees * std::numbers::pi / 180;
    const double c = std::cos(angle), s = std::sin(angle);
    path[k][0] = end[0] * c - end[2] * s;
    path[k][2] = end[0] * s + end[2] * c;
    path[k][3] = end[3] - glm::dvec4(move * left, 0);
  }
  return path;
}

}  // namespace sb
