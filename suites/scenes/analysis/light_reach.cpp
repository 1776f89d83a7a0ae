#include "suites/scenes/analysis/light_reach.h"

#include <algorithm>
#include <cmath>

#include "techniques/scene/light_area.h"
#include "techniques/scene/light_data.h"

namespace sb {
namespace {

double squaredDistance(glm::dvec3 p, const Box& box) {
  const glm::dvec3 away = glm::max(glm::max(box.low - p, p - box.high), glm::dvec3(0));
  return glm::dot(away, away);
}

// False only if the sphere lies outside the cone.
bool coneTouches(glm::dvec3 apex, glm::dvec3 axis, double angle, glm::dvec3 center, double radius) {
  if (angle >= 1.5707963) return true;
  const glm::dvec3 v = center - apex;
  const double along = glm::dot(v, axis);
  const double aside = std::sqrt(std::max(glm::dot(v, v) - along * along, 0.0));
  const double outside = aside * std::cos(angle) - along * std::sin(angle);
  return outside <= radius && along >= -radius;
}

}  // namespace

LightReach::LightReach(const Light& light, glm::dvec3 origin)
    : m_directional(light.type == LightType::Directional),
      m_dark(!(light.intensity > 0) ||
             std::max({light.color.r, light.color.g, light.color.b}) <= 0),
      m_cone(light.type == LightType::Spot),
      m_shape(light.shape),
      m_position(light.position - origin),
      m_direction(light.direction),
      m_range(light.range > 0 ? light.range : std::numeric_limits<double>::infinity()),
      m_radius(m_directional ? 0 : lightRadius(light)),
      m_outerCone(light.outerCone) {
  if (!m_directional) return;
  m_axes = lightAxes(light.direction);
  m_spread = std::tan(std::min(light.angularRadius, 1.5));
}

double LightReach::aside(const Box& receiver) const {
  return seenRadius(m_shape, m_radius, std::sqrt(squaredDistance(m_position, receiver)));
}

bool LightReach::mayLight(const Box& box) const {
  if (m_dark || box.empty()) return false;
  return m_directional || mayPass(box, 0);
}

bool LightReach::mayPass(const Box& box, double slack) const {
  const double reach = m_range + slack;
  if (squaredDistance(m_position, box) > reach * reach * (1 + 1e-6)) return false;
  if (!m_cone) return true;
  // What lies behind the apex gets nothing, however near (the sphere below may reach around it).
  const auto ahead = [&](int i) {
    return glm::dot(box.corner(i) - m_position, m_direction) >= -slack - 1e-6 * box.radius();
  };
  bool any = m_outerCone >= 1.5707963;
  for (int i = 0; i < 8; ++i) any |= ahead(i);
  return any && coneTouches(m_position, m_direction, m_outerCone, box.center(),
                            box.radius() * (1 + 1e-6) + slack);
}

Box LightReach::toLightSpace(const Box& box) const {
  Box turned;
  for (int i = 0; i < 8; ++i) turned.add(m_axes * box.corner(i));
  turned.grow(1e-6 * (turned.radius() + glm::length(turned.center())));
  return turned;
}

bool LightReach::sweptTouches(const Box& caster, const Box& receiver, double spread) {
  if (!(caster.high.z >= receiver.low.z)) return false;
  const double aside = spread * (caster.high.z - receiver.low.z);
  return caster.low.x - aside <= receiver.high.x && receiver.low.x <= caster.high.x + aside &&
         caster.low.y - aside <= receiver.high.y && receiver.low.y <= caster.high.y + aside;
}

bool LightReach::mayShadow(const Box& caster, const Box& receiver) const {
  if (caster.empty() || receiver.empty()) return false;
  if (m_directional) return sweptTouches(toLightSpace(caster), toLightSpace(receiver), m_spread);
  const double slack = aside(receiver);
  if (m_dark) return false;
  if (!std::isfinite(slack)) return true;  // within the light
  if (!mayPass(caster, slack)) return false;
  // All rays in question lie in the box around light and receiver.
  Box between{m_position, m_position};
  between.grow(slack);
  between.add(receiver);
  between.grow(1e-6 * (between.radius() + glm::length(between.center())));
  return between.touches(caster);
}

}  // namespace sb
