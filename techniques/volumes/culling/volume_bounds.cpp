#include "techniques/volumes/culling/volume_bounds.h"

#include <algorithm>

namespace sb {
bool VolumeBounds::liesOutside(std::span<const HalfSpace> halfSpaces) const {
  const double slack = kRasterSlack * (glm::length(caster.center()) + caster.radius());
  const auto outside = [&](const HalfSpace& h) {
    for (int i = 0; i < 8; ++i) {
      const glm::dvec3 corner = caster.corner(i);
      if (glm::dot(h.normal, corner) + h.offset >= -slack) return false;
      if (glm::dot(h.normal, corner * light.w - glm::dvec3(light)) + lightRadius > 0) return false;
    }
    return true;
  };
  return std::ranges::any_of(halfSpaces, outside);
}

Box VolumeBounds::within(double reach) const {
  Box box = caster;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 away = caster.corner(i) * light.w - glm::dvec3(light);
    const double length = glm::length(away);
    if (length == 0) continue;
    const glm::dvec3 from = light.w > 0 ? glm::dvec3(light) : caster.corner(i);
    box.add(from + away * (reach / length));
  }
  return box;
}

std::vector<HalfSpace> boxHalfSpaces(const Box& box) {
  std::vector<HalfSpace> halfSpaces;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 normal(0);
    normal[axis] = 1;
    halfSpaces.push_back({normal, -box.low[axis]});
    halfSpaces.push_back({-normal, box.high[axis]});
  }
  return halfSpaces;
}

}  // namespace sb
