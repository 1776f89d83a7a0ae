#include "suites/scenes/analysis/penumbra_bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "techniques/scene/light_area.h"

namespace sb {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr double kRightAngle = 1.5707963267948966;

double nearest(glm::dvec3 p, const Box& box) {
  return glm::length(glm::max(glm::max(box.low - p, p - box.high), glm::dvec3(0)));
}
double farthest(glm::dvec3 p, const Box& box) {
  return glm::length(glm::max(glm::abs(box.low - p), glm::abs(box.high - p)));
}

/// Along a plane at distance h, between incidences t - a and t + a.
double spread(double h, double t, double a) {
  return t + a < kRightAngle ? h * (std::tan(t + a) - std::tan(t - a)) : kUnbounded;
}

/// What the light sees of distances: from a directional one along its direction, else from its
/// middle.
class Distances {
 public:
  Distances(const Analysis& analysis, const LightEffects& effects)
      : m_light(analysis.placed.light(effects.light)),
        m_reach(m_light, analysis.eye),
        m_position(m_light.position - analysis.eye) {
    for (const auto* list :
         {&effects.opaqueCasters, &effects.perforatedCasters, &effects.translucentCasters})
      for (const uint32_t i : *list) addCaster(i, analysis.instances[i].box);
    for (const uint32_t m : effects.media) addCaster(kNone, analysis.media[m].box);
  }

  /// World units along the plane, of shadows that others than `receiver` throw onto its box.
  double onPlane(uint32_t receiver, const Box& box, const Plane& plane) const {
    const double first = m_caster == receiver ? m_otherFirst : m_first;
    if (m_reach.directional()) {
      const double drop = std::max(0.0, last(box) - first);
      const double cosine = std::min(1.0, std::abs(glm::dot(plane.normal, m_light.direction)));
      return spread(drop * cosine, std::acos(cosine), m_light.angularRadius);
    }
    const double drop = std::max(0.0, last(box) - first);
    if (drop == 0) return 0;
    const double sine = lightRadius(m_light) / std::max(first, 1e-300);
    if (sine >= 1) return kUnbounded;
    // The light's middle may fall beside the box, by up to the half angle.
    const double height = std::abs(glm::dot(plane.normal, m_position) - plane.offset);
    const double a = std::asin(sine);
    const double t = std::acos(std::min(1.0, height / last(box))) + a;
    return spread(std::min(drop, height), t, a);
  }
  /// May anything, itself included, throw a shadow onto it?
  bool mayShade(const Box& box) const { return m_first <= last(box); }

 private:
  double first(const Box& box) const {
    return m_reach.directional() ? -m_reach.toLightSpace(box).high.z : nearest(m_position, box);
  }
  double last(const Box& box) const {
    return m_reach.directional() ? -m_reach.toLightSpace(box).low.z : farthest(m_position, box);
  }
  void addCaster(uint32_t instance, const Box& box) {
    const double at = first(box);
    if (at < m_first) {
      m_otherFirst = m_first;
      m_first = at, m_caster = instance;
    } else {
      m_otherFirst = std::min(m_otherFirst, at);
    }
  }

  const Light& m_light;
  LightReach m_reach;
  glm::dvec3 m_position;
  double m_first = kUnbounded;       ///< of all casters
  double m_otherFirst = kUnbounded;  ///< of all but the first
  uint32_t m_caster = kNone;         ///< the first
};

}  // namespace

double penumbraBound(const Analysis& analysis, const LightEffects& light) {
  if (!isAreaLight(analysis.placed.light(light.light)) || !(light.casts() || !light.media.empty()))
    return 0;
  const Distances distances(analysis, light);
  double widest = 0;
  for (uint32_t i = 0; i < analysis.instances.size(); ++i) {
    const AnalysedInstance& instance = analysis.instances[i];
    if (!instance.visible || !instance.lit || !distances.mayShade(instance.box)) continue;
    double width = analysis.view.extent(instance.box);
    if (instance.plane)
      width = std::min(width, distances.onPlane(i, instance.box, *instance.plane) *
                                  analysis.view.heightsPerUnit(instance.box));
    widest = std::max(widest, width);
  }
  for (const AnalysedMedium& medium : analysis.media)
    if (medium.visible && medium.scatters && distances.mayShade(medium.box))
      widest = std::max(widest, analysis.view.extent(medium.box));
  return widest;
}

std::string penumbraBoundText(double bound) {
  if (bound >= 1) return "penumbrae that may be wider than the picture is high";
  return fmt::format("penumbrae of at most {:.3g} % of the picture's height", 100 * bound);
}

}  // namespace sb
