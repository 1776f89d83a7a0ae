// The volume that a camera sees, as planes and as a box, relative to the eye.
#pragma once

#include <vector>

#include "techniques/scene/tree/region.h"

namespace sb {

class ViewVolume {
 public:
  ViewVolume(const Camera& camera, double aspect);
  /// What all cameras see together, and each thing as near as any of them may come.
  static ViewVolume everywhere(double aspect);
  /// False only if nothing of the box can be seen. The box is relative to the eye.
  bool mayShow(const Box& box) const;
  /// False only if nothing of the sphere can be seen.
  bool mayShow(glm::dvec3 center, double radius) const;
  /// Bounds around the volume.
  const Box& bounds() const { return m_bounds; }
  /// Bounds of the picture (x, y in [-1, 1], z unused) around `box`; all of it where the box
  /// reaches behind the near plane.
  Box onScreen(const Box& box) const;
  /// Diagonal of what of it is in the picture, in heights of the picture.
  double extent(const Box& box) const;
  /// Heights of the picture that a world unit takes at most, within what of the box is seen; a very
  /// large number where a camera may come to any point.
  double heightsPerUnit(const Box& box) const;

 private:
  explicit ViewVolume(double aspect) : m_scaleX(1 / aspect) {}

  std::vector<HalfSpace> m_planes;  ///< none: everything is seen
  Box m_bounds;
  glm::dmat3 m_toView = glm::dmat3(1);
  double m_scaleX = 1, m_scaleY = 1, m_near = 0;
  bool m_orthographic = false;
};

}  // namespace sb
