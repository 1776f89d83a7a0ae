#include "techniques/volumes/culling/light_rectangle.h"

#include <algorithm>
#include <cmath>

namespace sb {
namespace {

/// Least and greatest x / depth of a circle in the plane of x and depth, each within [-limit,
/// limit].
std::pair<double, double> slopes(double x, double depth, double radius, double limit) {
  const double distance = std::hypot(x, depth);
  if (distance <= radius) return {-limit, limit};
  // Directions from straight ahead; beyond a right angle they are behind the eye.
  const double middle = std::atan2(x, depth), half = std::asin(radius / distance);
  const auto slope = [&](double angle) {
    const double right = std::acos(0.0);
    if (angle <= -right) return -limit;
    return angle >= right ? limit : std::clamp(std::tan(angle), -limit, limit);
  };
  return {slope(middle - half), slope(middle + half)};
}

/// Pixels of a line of `count` between two places in [-1, 1]; one more at either end.
std::pair<int32_t, int32_t> pixels(double low, double high, uint32_t count) {
  const auto at = [&](double place) { return 0.5 * (place + 1) * count; };
  return {std::max(0, int32_t(std::floor(at(low))) - 1),
          std::min(int32_t(count), int32_t(std::ceil(at(high))) + 1)};
}

}  // namespace

std::optional<rhi::Rect> sphereRectangle(const Camera& camera, rhi::Extent2D size,
                                         const Sphere& sphere) {
  const glm::dvec3 center = glm::transpose(glm::dmat3(camera.toWorld)) * sphere.center;
  const double halfY = camera.orthographic ? camera.halfHeight : std::tan(0.5 * camera.fovY);
  const double halves[2] = {halfY * size.width / size.height, halfY};
  std::pair<int32_t, int32_t> range[2];
  for (int axis = 0; axis < 2; ++axis) {
    const double half = halves[axis];
    const auto [low, high] = camera.orthographic
                                 ? std::pair(std::clamp(center[axis] - sphere.radius, -half, half),
                                             std::clamp(center[axis] + sphere.radius, -half, half))
                                 : slopes(center[axis], -center.z, sphere.radius, half);
    range[axis] = pixels(low / half, high / half, axis == 0 ? size.width : size.height);
  }
  const rhi::Rect rect{range[0].first, range[1].first,
                       uint32_t(std::max(0, range[0].second - range[0].first)),
                       uint32_t(std::max(0, range[1].second - range[1].first))};
  if (rect.width == size.width && rect.height == size.height) return {};
  return rect;
}

}  // namespace sb
