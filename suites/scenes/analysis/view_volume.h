// The volume that a camera sees, as planes and as a box, relative to the eye.
#pragma once

#include <array>

#include "suites/scenes/analysis/bounds.h"

namespace sb {

class ViewVolume {
 public:
  ViewVolume(const Camera& camera, double aspect);
  /// False only if nothing of the box can be seen. The box is relative to the eye.
  bool mayShow(const Bounds& box) const;
  /// False only if nothing of the sphere can be seen.
  bool mayShow(glm::dvec3 center, double radius) const;
  /// Bounds around the volume.
  const Bounds& bounds() const { return m_bounds; }
  /// Bounds of the picture (x, y in [-1, 1], z unused) around `box`; all of it where the box reaches
  /// behind the near plane.
  Bounds onScreen(const Bounds& box) const;
  /// Diagonal of what of it is in the picture, in heights of the picture.
  double extent(const Bounds& box) const;
  /// Heights of the picture that a world unit takes at most, within what of the box is seen.
  double heightsPerUnit(const Bounds& box) const;

 private:
  struct Plane {
    glm::dvec3 normal;  ///< unit, inward
    double offset;      ///< dot(normal, p) + offset >= 0 inside
  };
  std::array<Plane, 6> m_planes;
  Bounds m_bounds;
  glm::dmat3 m_toView;
  double m_scaleX = 1, m_scaleY = 1, m_near = 0;
  bool m_orthographic = false;
};

}  // namespace sb
