#include "suites/scenes/edit/world_path.h"

#include <cmath>
#include <numbers>

namespace sb {
namespace {

/// Angles that evenly arrive at 0, in radians.
double angleAt(uint32_t step, uint32_t steps, double degrees) {
  return -(degrees * std::numbers::pi / 180) * (1.0 - double(step + 1) / double(steps));
}

}  // namespace

std::vector<LightPose> lightCircle(const Light& light, const glm::dvec3& center, double degrees,
                                   uint32_t steps) {
  std::vector<LightPose> poses;
  const glm::dvec3 axis(center.x, 0, center.z);
  for (uint32_t k = 0; k < steps; ++k) {
    const double angle = angleAt(k, steps, degrees), c = std::cos(angle), s = std::sin(angle);
    const glm::dmat3 turn(c, 0, -s, 0, 1, 0, s, 0, c);
    poses.push_back(
        {axis + turn * (light.position - axis), turn * light.direction, turn * light.halfAxes});
  }
  poses.back() = {light.position, light.direction, light.halfAxes};
  return poses;
}

std::vector<glm::dmat4> circlePath(const glm::dmat4& end, const glm::dmat3& frame, double radius,
                                   uint32_t steps) {
  std::vector<glm::dmat4> path(steps, end);
  for (uint32_t k = 0; k + 1 < steps; ++k) {
    const double angle = angleAt(k, steps, 360), c = std::cos(angle), s = std::sin(angle);
    const glm::dmat3 turn = frame * glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1) * glm::transpose(frame);
    path[k] = glm::dmat4(turn * glm::dmat3(end));
    path[k][3] = end[3] + glm::dvec4(radius * (turn * frame[0] - frame[0]), 0);
  }
  return path;
}

}  // namespace sb
