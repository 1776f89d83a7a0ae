// Where one light's shadows can fall, conservatively. Positions are relative to the eye.
#pragma once

#include <vector>

#include "suites/scenes/analysis/view_volume.h"

namespace sb {

class LightReach {
 public:
  /// `origin` is the eye.
  LightReach(const Light& light, glm::dvec3 origin);
  /// False only if no light arrives anywhere in the box.
  bool mayLight(const Box& box) const;
  /// False only if no ray from the light to a point of `receiver` meets `caster`.
  bool mayShadow(const Box& caster, const Box& receiver) const;
  /// The same, of boxes that were turned by toLightSpace() (directional lights).
  static bool sweptTouches(const Box& caster, const Box& receiver, double spread);
  /// Around a box in the light's axes (directional lights).
  Box toLightSpace(const Box& box) const;
  bool directional() const { return m_directional; }
  /// lightAxes() of a directional light.
  const glm::dmat3& axes() const { return m_axes; }
  /// How far the shadow's rim moves aside per unit of depth (directional lights with an angular
  /// radius).
  double spread() const { return m_spread; }

 private:
  /// How far from its centre the light may be aimed at from points of the box (LightPatch), of
  /// point and spot lights.
  double aside(const Box& receiver) const;
  /// The same, where rays to the light may pass `slack` beside the rays to its centre.
  bool mayPass(const Box& box, double slack) const;

  bool m_directional, m_dark, m_cone;
  LightShape m_shape;
  glm::dmat3 m_axes = glm::dmat3(1);
  double m_spread = 0;
  glm::dvec3 m_position, m_direction;
  double m_range, m_radius, m_outerCone;
};

}  // namespace sb
