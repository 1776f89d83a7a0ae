// One ray's search for triangles: tests those that a walk through the tree (box_walk.h) comes upon,
// or all of them, and keeps what a judge says.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "suites/truth/rays/bvh.h"
#include "suites/truth/rays/watertight.h"

namespace sb {

class RaySearch {
 public:
  /// In place: what is copied right after it was written, the CPU waits for. `alike`: a search in
  /// the same direction, if there is one; its heading is taken over.
  void begin(const std::vector<TruthTriangle>& triangles, const TruthRay& ray,
             std::vector<TruthHit>& out, const RaySearch* alike = nullptr) {
    m_triangles = triangles.data();
    m_ray = &ray;
    m_out = &out;
    m_nearest = std::numeric_limits<double>::infinity();
    m_stopped = false;
    if (alike)
      takeHeading(*alike);
    else
      head(ray.direction);
    m_sheared.start(ray.origin);
    out.clear();
  }

  template <class Judge>
  void test(uint32_t index, const Judge& judge) {
    if (m_stopped) return;
    const auto hit = intersect(m_sheared, m_triangles[index].corners);
    if (!hit || !(hit->t > m_ray->tMin) || !(hit->t < m_ray->tMax) || hit->t > m_nearest) return;
    const TruthHit found{hit->t, hit->b, hit->c, index, hit->front};
    const Bvh::Verdict verdict = judge(found);
    if (verdict == Bvh::Verdict::Ignore) return;
    if (verdict == Bvh::Verdict::Stop) {
      m_stopped = true;
      *m_out = {found};
      return;
    }
    if (verdict == Bvh::Verdict::Nearest) m_nearest = std::min(m_nearest, hit->t + m_ray->tie);
    m_out->push_back(found);
  }

  void finish() {
    if (m_out->size() < 2) return;
    std::ranges::sort(*m_out, {}, [](const TruthHit& h) { return std::tuple(h.t, h.triangle); });
    std::erase_if(*m_out, [&](const TruthHit& h) { return h.t > m_nearest; });
  }

  /// Sets out as the tree's walks take it. `margin`: that of the tree.
  void setOut(double margin, WalkRay& ray) {
    m_slack = 2 * margin;
    ray.end = end(m_ray->tMax);
    ray.kx = m_sheared.kx, ray.ky = m_sheared.ky, ray.kz = m_sheared.kz;
    ray.ox = m_sheared.ox, ray.oy = m_sheared.oy, ray.oz = m_sheared.oz;
    ray.sx = m_sheared.sx, ray.sy = m_sheared.sy;
    ray.own = m_ray->own;
    for (int axis = 0; axis < 3; ++axis) {
      ray.origin[axis] = float(glm::value_ptr(m_ray->origin)[axis]);
      ray.inverse[axis] = m_inverse[axis];
    }
  }
  /// How far to walk on, having walked to `before`.
  float walkedEnd(float before) const {
    if (m_stopped) return -1;
    return m_nearest < std::numeric_limits<double>::infinity() ? std::min(before, end(m_nearest))
                                                               : before;
  }

 private:
  /// Boxes that begin behind need not be entered.
  float end(double t) const { return float(t * m_length * (1 + 1e-5) + m_slack); }

  void head(const glm::dvec3& direction) {
    m_sheared.head(direction);
    const double side = std::copysign(1, m_sheared.dz);
    m_length = std::abs(m_sheared.dz);
    m_inverse[m_sheared.kx] = inverseOf(side * m_sheared.sx);
    m_inverse[m_sheared.ky] = inverseOf(side * m_sheared.sy);
    m_inverse[m_sheared.kz] = float(side);
  }
  void takeHeading(const RaySearch& other) {
    m_sheared = other.m_sheared;
    m_length = other.m_length;
    std::ranges::copy(other.m_inverse, m_inverse);
  }
  /// Components that are smaller shares of the largest one move nothing by a margin within the
  /// scene.
  static constexpr float kLeastShare = 1e-18f;
  static float inverseOf(double share) {
    const float s = float(share);
    return 1 / std::copysign(std::max(std::abs(s), kLeastShare), s);
  }

  const TruthTriangle* m_triangles;
  const TruthRay* m_ray;
  ShearedRay<double> m_sheared;
  std::vector<TruthHit>* m_out;
  float m_inverse[3];  ///< of the direction over its largest component
  double m_length;     ///< the largest component
  double m_slack;
  double m_nearest;
  bool m_stopped;
};

}  // namespace sb
