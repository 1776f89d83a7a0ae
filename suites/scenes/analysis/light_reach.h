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
  bool mayLight(const Bounds& box) const;
  /// False only if no ray from the light to a point of `receiver` meets `caster`.
  bool mayShadow(const Bounds& caster, const Bounds& receiver) const;
  /// The same, of boxes that were turned by toLightSpace() (directional lights).
  static bool sweptTouches(const Bounds& caster, const Bounds& receiver, double spread);
  /// Bounds around a box in the light's frame: x, y across the light, z along it (directional lights).
  Bounds toLightSpace(const Bounds& box) const;
  bool directional() const { return m_directional; }
  /// Turns positions relative to the eye into the light's frame (directional lights).
  const glm::dmat3& frame() const { return m_toLight; }
  /// How far the shadow's rim moves aside per unit of depth (directional lights with an angular
  /// radius).
  double spread() const { return m_spread; }

 private:
  /// How far from its centre the light may be aimed at from points of the box (LightPatch), of
  /// point and spot lights.
  double aside(const Bounds& receiver) const;
  /// The same, where rays to the light may pass `slack` beside the rays to its centre.
  bool mayPass(const Bounds& box, double slack) const;

  bool m_directional, m_dark, m_cone, m_solid;
  glm::dmat3 m_toLight;  ///< directional: rows x, y across and z along the direction
  double m_spread = 0;
  glm::dvec3 m_position, m_direction;
  double m_range, m_radius, m_outerCone;
};

}  // namespace sb
