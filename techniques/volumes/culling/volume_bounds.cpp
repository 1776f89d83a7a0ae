#include "techniques/volumes/culling/volume_bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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
  if (light.w > 0) {
    box.add(capBox(reach));
    return box;
  }
  for (int i = 0; i < 8; ++i) box.add(caster.corner(i) - glm::dvec3(light) * reach);
  return box;
}

Box VolumeBounds::capBox(double reach) const {
  const glm::dvec3 place(light);
  const glm::dvec3 axis = caster.center() - place;
  // Half the angle of the cone around the caster; a lamp in its box shines all around.
  double angle = 0;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 way = caster.corner(i) - place;
    angle = std::max(angle, std::atan2(glm::length(glm::cross(axis, way)), glm::dot(axis, way)));
  }
  Box box{place - reach, place + reach};
  if (axis == glm::dvec3(0) || angle >= std::numbers::pi / 2) return box;
  const glm::dvec3 middle = glm::normalize(axis);
  const auto toward = [&](double cosine) {
    const double between = std::max(0.0, std::acos(std::clamp(cosine, -1.0, 1.0)) - angle);
    return reach * std::cos(between);
  };
  for (int k = 0; k < 3; ++k) {
    box.low[k] = place[k] - toward(-middle[k]);
    box.high[k] = place[k] + toward(middle[k]);
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
