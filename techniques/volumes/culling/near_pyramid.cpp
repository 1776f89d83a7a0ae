#include "techniques/volumes/culling/near_pyramid.h"

#include "techniques/scene/camera.h"

namespace sb {

std::array<glm::dvec3, 4> nearRectangle(const Camera& camera, double aspect) {
  const auto corners = frustumCorners(camera, aspect, camera.nearPlane);
  return {corners[0], corners[1], corners[3], corners[2]};
}

bool meetsNearPyramid(const std::array<glm::dvec3, 4>& rectangle, const glm::dvec4& light,
                      const glm::dvec3& center, double radius) {
  const glm::dvec3 middle = 0.25 * (rectangle[0] + rectangle[1] + rectangle[2] + rectangle[3]);
  const glm::dvec3 toLight = glm::dvec3(light) - light.w * middle;
  // Of what subtraction leaves of coordinates of that size.
  const double slack = 1e-9 * (glm::length(center) + radius + glm::length(toLight) * light.w);
  const auto outside = [&](glm::dvec3 normal, const glm::dvec3& point, const glm::dvec3& within) {
    normal = glm::normalize(normal);
    if (glm::dot(normal, within) > 0) normal = -normal;
    return glm::dot(normal, center - point) > radius + slack;
  };
  const glm::dvec3 plane =
      glm::normalize(glm::cross(rectangle[1] - rectangle[0], rectangle[3] - rectangle[0]));
  if (std::abs(glm::dot(plane, toLight)) <= 1e-6 * glm::length(toLight)) return true;
  if (outside(plane, middle, toLight)) return false;
  for (size_t i = 0; i < 4; ++i) {
    const glm::dvec3 &a = rectangle[i], &b = rectangle[(i + 1) % 4];
    const glm::dvec3 along = glm::dvec3(light) - light.w * a;
    if (outside(glm::cross(b - a, along), a, middle - a)) return false;
  }
  return true;
}

}  // namespace sb
