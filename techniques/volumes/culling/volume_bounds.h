// Bounds of a shadow volume, made of its caster's box alone (thesis of the third source document,
// section 5.2; spec 07, culling). Everything is relative to the eye.
#pragma once

#include <span>

#include "techniques/scene/tree/region.h"

namespace sb {

/// What a box keeps from a light, to infinity.
struct VolumeBounds {
  Box caster;
  glm::dvec4 light;  ///< where it is, w 1; or the way to it (unit), w 0
  /// No point of the light lies farther from there: the volume is then all that may be dimmed.
  double lightRadius = 0;

  /// True only where the volume lies outside one of the half spaces.
  bool liesOutside(std::span<const HalfSpace> halfSpaces) const;
  /// Around the volume where it ends `reach` from the light (directional: behind the caster).
  Box within(double reach) const;

 private:
  /// Around what the cone of a lamp's rays through the caster cuts out of the sphere of that
  /// radius: it bulges beyond the rays through the corners.
  Box capBox(double reach) const;
};

/// The six half spaces of a box.
std::vector<HalfSpace> boxHalfSpaces(const Box& box);

}  // namespace sb
