#include "techniques/scene/light_area.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "techniques/scene/light_data.h"

namespace sb {

using glm::dmat3;
using glm::dvec2;
using glm::dvec3;

namespace {

constexpr double kQuarterPi = 0.78539816339744830962;

/// Any two unit vectors perpendicular to `axis` and to one another.
std::array<dvec3, 2> across(const dvec3& axis) {
  const dmat3 rows = lightAxes(axis);
  return {dvec3(rows[0].x, rows[1].x, rows[2].x), dvec3(rows[0].y, rows[1].y, rows[2].y)};
}

}  // namespace

bool isAreaLight(const Light& light) {
  return light.type == LightType::Directional ? light.angularRadius > 0
                                              : light.shape != LightShape::Point;
}

double lightRadius(const Light& light) {
  if (light.shape == LightShape::Point) return 0;
  const double a = glm::length(light.halfAxes[0]), b = glm::length(light.halfAxes[1]);
  if (light.shape == LightShape::Rectangle) return std::hypot(a, b);
  return std::max({a, b, glm::length(light.halfAxes[2])});
}

double seenRadius(LightShape shape, double radius, double distance) {
  if (shape != LightShape::Ellipsoid) return radius;
  const double d2 = distance * distance, r2 = radius * radius;
  return d2 > r2 ? radius * std::sqrt(d2 / (d2 - r2)) : std::numeric_limits<double>::infinity();
}

bool isSphere(const Light& light) {
  return light.shape == LightShape::Ellipsoid && light.halfAxes == dmat3(light.halfAxes[0][0]);
}

void makeSphere(Light& light, double radius) {
  light.shape = radius > 0 ? LightShape::Ellipsoid : LightShape::Point;
  light.halfAxes = dmat3(radius);
}

LightPatch lightPatch(const Light& light, const dvec3& toCentre) {
  LightPatch patch{.centre = toCentre};
  if (light.type == LightType::Directional) {
    patch.centre = -glm::normalize(light.direction);
    patch.infinite = true;
    if (light.angularRadius == 0) return patch;
    const auto [x, y] = across(patch.centre);
    const double radius = std::tan(light.angularRadius);
    patch.u = radius * x;
    patch.v = radius * y;
    patch.round = true;
    // A surface that faces it receives its illuminance.
    patch.power = 1 + radius * radius;
    return patch;
  }
  patch.u = light.halfAxes[0];
  patch.v = light.halfAxes[1];
  patch.round = light.shape == LightShape::Ellipsoid || light.shape == LightShape::Disc;
  // Straight before a flat shape, and from anywhere about a sphere, the far field is the light's
  // intensity.
  patch.power = 1;
  if (light.shape != LightShape::Ellipsoid) return patch;
  // Where the ellipsoid is the unit sphere.
  const dvec3 view = glm::inverse(light.halfAxes) * toCentre;
  const double d2 = glm::dot(view, view);
  patch.inside = d2 <= 1;
  if (patch.inside) return patch;
  const auto [x, y] = across(view);
  const double radius = std::sqrt(d2 / (d2 - 1));
  patch.u = radius * (light.halfAxes * x);
  patch.v = radius * (light.halfAxes * y);
  const double a = std::cbrt(std::abs(glm::determinant(light.halfAxes)));
  patch.power = glm::length(glm::cross(patch.u, patch.v)) / (a * a);
  return patch;
}

size_t LightPatch::hull(std::array<dvec3, 8>& corners) const {
  if (!round) {
    corners = {centre + u + v, centre - u + v, centre - u - v, centre + u - v};
    return 4;
  }
  const double outward = 1 / std::cos(kQuarterPi / 2);
  for (size_t i = 0; i < 8; ++i) {
    const double angle = (double(i) + 0.5) * kQuarterPi;
    corners[i] = centre + outward * (std::cos(angle) * u + std::sin(angle) * v);
  }
  return 8;
}

dvec2 onSquare(const dvec2& square) { return 2.0 * square - 1.0; }

dvec2 onDisc(const dvec2& square) {
  const dvec2 s = onSquare(square);
  if (s == dvec2(0)) return s;
  const bool wide = std::abs(s.x) > std::abs(s.y);
  const double r = wide ? s.x : s.y;
  const double angle = wide ? kQuarterPi * (s.y / s.x) : 2 * kQuarterPi - kQuarterPi * (s.x / s.y);
  return r * dvec2(std::cos(angle), std::sin(angle));
}

glm::uvec2 sequencePoint(uint32_t i) {
  glm::uvec2 point(0);
  uint32_t first = 1u << 31, second = 1u << 31;
  for (; i != 0; i >>= 1, first >>= 1, second ^= second >> 1)
    if (i & 1) point ^= glm::uvec2(first, second);
  return point;
}

dvec2 netPoint(uint32_t i, uint32_t count) {
  return dvec2(sequencePoint(i)) * 0x1p-32 + 0.5 / count;
}

}  // namespace sb
