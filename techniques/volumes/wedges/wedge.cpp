#include "techniques/volumes/wedges/wedge.h"

#include <algorithm>
#include <cmath>

#include "techniques/scene/light_area.h"

namespace sb {
namespace {

using glm::dvec3;

/// Nearer ends touch the light.
constexpr double kTouches = 1 + 1e-4;
/// By which share of the distance a plane may miss.
constexpr double kTolerance = 1e-5;

dvec3 acrossAny(const dvec3& axis) {
  const dvec3 other = std::abs(axis.x) < std::abs(axis.y) ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
  return glm::normalize(glm::cross(axis, other));
}

/// A light in the space where wedges are made: a unit sphere about zero, or directional.
struct Space {
  const WedgeLight& light;

  dvec3 in(const dvec3& p) const {
    return light.directional ? p : light.toUnit * (p - light.centre);
  }
  dvec3 out(const dvec3& p) const {
    return light.directional ? p : light.fromUnit * p + light.centre;
  }
  dvec3 inWay(const dvec3& d) const { return light.directional ? d : light.toUnit * d; }
  dvec3 outWay(const dvec3& d) const { return light.directional ? d : light.fromUnit * d; }

  dvec3 toward(const dvec3& e) const {
    return light.directional ? light.centre : -glm::normalize(e);
  }
  /// Of the angle under which the light is seen.
  double sine(const dvec3& e) const { return light.directional ? light.sine : 1 / glm::length(e); }
  /// How far out of reach the light is.
  double before(const dvec3& e) const {
    return light.directional ? -glm::dot(e, light.centre) : glm::length(e);
  }
  /// A point as far from the light as the nearer one, on the way to another.
  dvec3 moved(const dvec3& far, const dvec3& near) const {
    if (light.directional) return far + light.centre * glm::dot(near - far, light.centre);
    return far * (glm::length(near) / glm::length(far));
  }
  /// Most of N . (l - q) over the light's points l, over |q|; directional: N . l over its ways.
  double beyond(const dvec3& normal, const dvec3& q) const {
    if (!light.directional) return (1 - glm::dot(normal, q)) / glm::length(q);
    const double angle = std::acos(std::clamp(glm::dot(normal, light.centre), -1.0, 1.0));
    return std::cos(std::max(0.0, angle - std::asin(light.sine)));
  }
};

/// Of the plane that touches the light and leaves the side `b` (unit, across the way to it).
dvec3 tangent(const Space& space, const dvec3& e, const dvec3& b) {
  const double sine = space.sine(e);
  return b * std::sqrt(1 - sine * sine) - space.toward(e) * sine;
}

/// The theorem of spec 08: x = e + s (e - l) lies within a plane for all l and e if the light lies
/// without and the edge within. Asked of the hull as it is drawn, after rounding.
bool holds(const Space& space, const std::array<glm::vec4, 6>& hull, const dvec3& a,
           const dvec3& b) {
  dvec3 way[4];
  dvec3 middle(0);
  for (size_t i = 0; i < 4; ++i) {
    way[i] = glm::normalize(space.inWay(dvec3(hull[i + 2])));
    middle += way[i];
  }
  const dvec3 start = space.in(dvec3(hull[0])), end = space.in(dvec3(hull[1]));
  const std::array<std::array<dvec3, 3>, 4> planes = {{{start, way[0], way[2]},
                                                       {start, way[1], way[3]},
                                                       {start, way[0], way[1]},
                                                       {end, way[2], way[3]}}};
  for (const auto& [q, u, v] : planes) {
    dvec3 normal = glm::normalize(glm::cross(u, v));
    if (glm::dot(normal, middle) < 0) normal = -normal;
    const double within = kTolerance * std::max(glm::length(q), glm::length(a - b));
    // Comparisons that NaN fails.
    if (!(space.beyond(normal, q) <= kTolerance)) return false;
    if (!(std::min(glm::dot(normal, a - q), glm::dot(normal, b - q)) >= -within)) return false;
  }
  return true;
}

}  // namespace

WedgeLight wedgeLight(const Light& light, const dvec3& eye) {
  if (light.type == LightType::Directional)
    return {.centre = -glm::normalize(light.direction),
            .directional = true,
            .sine = std::sin(light.angularRadius)};
  WedgeLight w{.centre = light.position - eye};
  w.fromUnit =
      light.shape == LightShape::Ellipsoid ? light.halfAxes : glm::dmat3(lightRadius(light));
  w.toUnit = glm::inverse(w.fromUnit);
  return w;
}

Wedge wedge(const WedgeLight& light, const dvec3& a, const dvec3& b) {
  const Space space{light};
  const dvec3 from = space.in(a), to = space.in(b);
  const bool swapped = space.before(to) < space.before(from);
  const dvec3 start = swapped ? to : from, far = swapped ? from : to;
  Wedge wedge;
  if (!light.directional && glm::length(start) <= kTouches) return wedge;
  const dvec3 end = space.moved(far, start);
  const dvec3 middle = 0.5 * (start + end);
  if (!light.directional && glm::length(middle) <= kTouches) return wedge;
  const dvec3 toward = space.toward(middle);
  // An edge that points at the light: its wedge is a pyramid.
  const double size = light.directional ? glm::distance(start, far) : glm::length(start);
  const dvec3 u =
      glm::distance(start, end) < 1e-6 * size ? acrossAny(toward) : glm::normalize(end - start);
  const dvec3 n = glm::cross(toward, u);
  const dvec3 front = tangent(space, middle, n), back = tangent(space, middle, -n);
  // Across the way from each end, on the side of the other.
  const auto side = [&](const dvec3& e, const dvec3& other) {
    const dvec3 w = space.toward(e);
    const dvec3 across = glm::normalize(u - w * glm::dot(u, w));
    return tangent(space, e, glm::dot(across, other) < 0 ? -across : across);
  };
  const dvec3 left = side(start, u), right = side(end, -u);
  const auto ray = [&](const dvec3& plane, const dvec3& atEnd, const dvec3& e) {
    const dvec3 d = glm::normalize(glm::cross(plane, atEnd));
    return glm::dot(d, space.toward(e)) > 0 ? -d : d;
  };
  const bool mirrored = !light.directional && glm::determinant(light.fromUnit) < 0;
  const dvec3 &before = mirrored ? back : front, &behind = mirrored ? front : back;
  wedge.hull = {glm::vec4(space.out(start), 1),
                glm::vec4(space.out(end), 1),
                glm::vec4(space.outWay(ray(before, left, start)), 0),
                glm::vec4(space.outWay(ray(behind, left, start)), 0),
                glm::vec4(space.outWay(ray(before, right, end)), 0),
                glm::vec4(space.outWay(ray(behind, right, end)), 0)};
  wedge.holds = holds(space, wedge.hull, from, to);
  return wedge;
}

}  // namespace sb
