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

/// A direction as searches and walks take it: what rays that run alike share.
class Heading {
 public:
  Heading() = default;
  explicit Heading(const glm::dvec3& direction) : m_direction(direction) {
    sheared.head(direction);
    const double side = std::copysign(1, sheared.dz);
    length = std::abs(sheared.dz);
    inverse[sheared.kx] = inverseOf(side * sheared.sx);
    inverse[sheared.ky] = inverseOf(side * sheared.sy);
    inverse[sheared.kz] = float(side);
  }
  bool isThatOf(const glm::dvec3& direction) const { return direction == m_direction; }

  ShearedRay<double> sheared;  ///< without an origin
  float inverse[3];            ///< of the direction over its largest component
  double length;               ///< the largest component

 private:
  /// Components that are smaller shares of the largest one move nothing by a margin within the
  /// scene.
  static constexpr float kLeastShare = 1e-18f;
  static float inverseOf(double share) {
    const float s = float(share);
    return 1 / std::copysign(std::max(std::abs(s), kLeastShare), s);
  }

  glm::dvec3 m_direction = glm::dvec3(0);
};

class RaySearch {
 public:
  /// In place, number by number: what is copied right after it was written, the CPU waits for. All
  /// that is given must outlive the search. `margin`: that of the tree.
  void begin(const std::vector<TruthTriangle>& triangles, const TruthRay& ray,
             const Heading& heading, double margin, WalkLine& line, std::vector<TruthHit>& out) {
    m_triangles = triangles.data();
    m_ray = &ray;
    m_out = &out;
    m_line = &line;
    m_dz = heading.sheared.dz;
    m_length = heading.length;
    m_slack = 2 * margin;
    m_nearest = std::numeric_limits<double>::infinity();
    m_stopped = false;
    const ShearedRay<double>& h = heading.sheared;
    line.kx = h.kx, line.ky = h.ky, line.kz = h.kz;
    line.sx = h.sx, line.sy = h.sy;
    const double* origin = glm::value_ptr(ray.origin);
    line.ox = origin[h.kx], line.oy = origin[h.ky], line.oz = origin[h.kz];
    line.own = ray.own;
    out.clear();
  }
  template <class Judge>
  void test(uint32_t index, const Judge& judge) {
    if (m_stopped) return;
    const auto hit = intersect(sheared(), m_triangles[index].corners);
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

  /// How far to walk at most.
  float end() const { return end(m_ray->tMax); }
  /// How far to walk on, having walked to `before`.
  float walkedEnd(float before) const {
    if (m_stopped) return -1;
    return m_nearest < std::numeric_limits<double>::infinity() ? std::min(before, end(m_nearest))
                                                               : before;
  }

 private:
  /// Boxes that begin behind need not be entered.
  float end(double t) const { return float(t * m_length * (1 + 1e-5) + m_slack); }

  ShearedRay<double> sheared() const {
    ShearedRay<double> ray;
    ray.kx = m_line->kx, ray.ky = m_line->ky, ray.kz = m_line->kz;
    ray.sx = m_line->sx, ray.sy = m_line->sy, ray.dz = m_dz;
    ray.ox = m_line->ox, ray.oy = m_line->oy, ray.oz = m_line->oz;
    return ray;
  }

  const TruthTriangle* m_triangles;
  const TruthRay* m_ray;
  std::vector<TruthHit>* m_out;
  const WalkLine* m_line;
  double m_dz;      ///< as ShearedRay
  double m_length;  ///< the direction's largest component
  double m_slack;
  double m_nearest;
  bool m_stopped;
};

}  // namespace sb
