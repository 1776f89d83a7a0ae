// The wedge around the penumbra that an edge throws from a light with an extent (spec 08, "Wedge
// construction"): four planes that touch the light, through the edge and through its ends. It only
// bounds work; shares of the light are those of the original edge. A wedge that cannot be shown to
// hold the penumbra is all that is seen.
#pragma once

#include <array>

#include "techniques/scene/scene.h"

namespace sb {

/// A light as wedges take it: a sphere around it, or an ellipsoid where it is one.
struct WedgeLight {
  glm::dmat3 toUnit = glm::dmat3(1),
             fromUnit = glm::dmat3(1);  ///< local: where it is a unit sphere
  glm::dvec3 centre = glm::dvec3(0);    ///< relative to the eye; directional: the way to it, unit
  bool directional = false;
  double sine = 0;  ///< directional: of its angular radius
};
WedgeLight wedgeLight(const Light& light, const glm::dvec3& eye);

struct Wedge {
  /// Homogeneous, relative to the eye; gpu::WedgeData::hull.
  std::array<glm::vec4, 6> hull{};
  bool holds = false;  ///< else the hull is not to be used
};
/// Of the edge between two points relative to the eye.
Wedge wedge(const WedgeLight& light, const glm::dvec3& a, const glm::dvec3& b);

}  // namespace sb
