#include "suites/scenes/analysis/view_volume.h"

#include <algorithm>
#include <cmath>

namespace sb {
ViewVolume::ViewVolume(const Camera& camera, double aspect)
    : m_toView(glm::transpose(glm::dmat3(camera.toWorld))),
      m_near(camera.nearPlane),
      m_orthographic(camera.orthographic) {
  const double halfY = m_orthographic ? camera.halfHeight : std::tan(0.5 * camera.fovY);
  const double halfX = halfY * aspect;
  m_scaleX = 1 / halfX, m_scaleY = 1 / halfY;
  const glm::dmat3 toWorld(camera.toWorld);
  m_planes = frustumHalfSpaces(camera, aspect);
  for (const double depth : {camera.nearPlane, camera.farPlane}) {
    const double reach = m_orthographic ? 1 : depth;
    for (const double x : {-halfX, halfX})
      for (const double y : {-halfY, halfY})
        m_bounds.add(toWorld * glm::dvec3(x * reach, y * reach, -depth));
  }
  m_bounds.grow(kRasterSlack * m_bounds.radius());
}

ViewVolume ViewVolume::everywhere(double aspect) {
  ViewVolume all(aspect);
  const glm::dvec3 infinity(std::numeric_limits<double>::infinity());
  all.m_bounds = {-infinity, infinity};
  return all;
}

bool ViewVolume::mayShow(const Box& box) const {
  if (box.empty()) return false;
  for (const HalfSpace& plane : m_planes) {
    const glm::dvec3 furthest(plane.normal.x > 0 ? box.high.x : box.low.x,
                              plane.normal.y > 0 ? box.high.y : box.low.y,
                              plane.normal.z > 0 ? box.high.z : box.low.z);
    if (glm::dot(plane.normal, furthest) + plane.offset < -kRasterSlack * glm::length(furthest))
      return false;
  }
  return true;
}

bool ViewVolume::mayShow(glm::dvec3 center, double radius) const {
  return std::ranges::all_of(m_planes, [&](const HalfSpace& plane) {
    return glm::dot(plane.normal, center) + plane.offset >=
           -radius - kRasterSlack * (glm::length(center) + radius);
  });
}

Box ViewVolume::onScreen(const Box& box) const {
  if (m_planes.empty()) return {{-1, -1, 0}, {1, 1, 0}};
  Box screen;
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 p = m_toView * box.corner(i);
    if (!m_orthographic && -p.z < m_near) return {{-1, -1, 0}, {1, 1, 0}};
    const double w = m_orthographic ? 1 : -p.z;
    screen.add({p.x * m_scaleX / w, p.y * m_scaleY / w, 0});
  }
  screen.grow(kRasterSlack);
  screen.low.z = screen.high.z = 0;
  return screen;
}

double ViewVolume::extent(const Box& box) const {
  const Box seen = onScreen(box).clippedTo({{-1, -1, 0}, {1, 1, 0}});
  const glm::dvec3 size = seen.high - seen.low;
  return seen.empty() ? 0 : 0.5 * std::hypot(size.x * m_scaleY / m_scaleX, size.y);
}

double ViewVolume::heightsPerUnit(const Box& box) const {
  if (m_planes.empty()) return std::numeric_limits<double>::max();
  if (m_orthographic) return 0.5 * m_scaleY;
  double depth = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 8; ++i) depth = std::min(depth, -(m_toView * box.corner(i)).z);
  // A length that recedes beside the axis is seen longer than one across the view.
  const double aside = std::hypot(1.0, 1 / m_scaleX, 1 / m_scaleY);
  return 0.5 * m_scaleY * aside / std::max(depth, m_near);
}

}  // namespace sb
