#include "techniques/scene/tree/region.h"

#include <algorithm>
#include <cmath>

namespace sb {
namespace {

Lies worse(Lies a, Lies b) { return std::min(a, b); }

Lies liesToPlane(const HalfSpace& h, const glm::dvec3& center, const glm::dvec3& half) {
  const double height = glm::dot(h.normal, center) + h.offset;
  const double extent = glm::dot(glm::abs(h.normal), half);
  const double slack = kRasterSlack * (glm::length(center) + glm::length(half));
  if (height + extent < -slack) return Lies::Outside;
  return height - extent > slack ? Lies::Inside : Lies::Across;
}

Lies liesToSphere(const Sphere& s, const Box& box) {
  const glm::dvec3 nearest = glm::clamp(s.center, box.low, box.high);
  const double slack = kRasterSlack * (s.radius + box.radius());
  if (glm::distance(nearest, s.center) > s.radius + slack) return Lies::Outside;
  const glm::dvec3 farthest = glm::max(glm::abs(box.low - s.center), glm::abs(box.high - s.center));
  return glm::length(farthest) < s.radius - slack ? Lies::Inside : Lies::Across;
}

}  // namespace

Lies ConvexRegion::lies(const Box& box) const {
  if (box.empty()) return Lies::Outside;
  const glm::dvec3 center = box.center() - origin, half = 0.5 * (box.high - box.low);
  Lies lies = sphere ? liesToSphere(*sphere, box) : Lies::Inside;
  for (const HalfSpace& h : halfSpaces) {
    if (lies == Lies::Outside) break;
    lies = worse(lies, liesToPlane(h, center, half));
  }
  return lies;
}

std::vector<HalfSpace> frustumHalfSpaces(const Camera& camera, double aspect) {
  const double halfY = camera.orthographic ? camera.halfHeight : std::tan(0.5 * camera.fovY);
  const double halfX = halfY * aspect;
  const glm::dmat3 toWorld(camera.toWorld);
  const auto plane = [&](glm::dvec3 normal, double offset) {
    const double length = glm::length(normal);
    return HalfSpace{toWorld * normal / length, offset / length};
  };
  const double z = camera.orthographic ? 0 : -1, o = camera.orthographic ? 1 : 0;
  return {plane({0, 0, -1}, -camera.nearPlane), plane({0, 0, 1}, camera.farPlane),
          plane({1, 0, z * halfX}, o * halfX),  plane({-1, 0, z * halfX}, o * halfX),
          plane({0, 1, z * halfY}, o * halfY),  plane({0, -1, z * halfY}, o * halfY)};
}

}  // namespace sb
