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
  RaySearch() = default;
  /// All that is given must outlive the search, but for the ray.
  RaySearch(const std::vector<TruthTriangle>& triangles, const TruthRay& ray,
            std::vector<TruthHit>& out)
      : m_triangles(triangles.data()),
        m_out(&out),
        m_sheared(ray.origin, ray.direction),
        m_tMin(ray.tMin),
        m_tMax(ray.tMax),
        m_tie(ray.tie) {
    out.clear();
  }
  template <class Judge>
  void test(uint32_t index, const Judge& judge) {
    if (m_stopped) return;
    const auto hit = intersect(m_sheared, m_triangles[index].corners);
    if (!hit || !(hit->t > m_tMin) || !(hit->t < m_tMax) || hit->t > m_nearest) return;
    const TruthHit found{hit->t, hit->b, hit->c, index, hit->front};
    const Bvh::Verdict verdict = judge(found);
    if (verdict == Bvh::Verdict::Ignore) return;
    if (verdict == Bvh::Verdict::Stop) {
      m_stopped = true;
      *m_out = {found};
      return;
    }
    if (verdict == Bvh::Verdict::Nearest) m_nearest = std::min(m_nearest, hit->t + m_tie);
    m_out->push_back(found);
  }

  void finish() {
    if (m_out->size() < 2) return;
    std::ranges::sort(*m_out, {}, [](const TruthHit& h) { return std::tuple(h.t, h.triangle); });
    std::erase_if(*m_out, [&](const TruthHit& h) { return h.t > m_nearest; });
  }

  bool stopped() const { return m_stopped; }
  /// Up to which t to walk on; negative: not at all.
  double walkTo() const { return m_stopped ? -1 : m_nearest; }

 private:
  const TruthTriangle* m_triangles;
  std::vector<TruthHit>* m_out;
  ShearedRay<double> m_sheared;
  double m_tMin, m_tMax, m_tie;
  double m_nearest = std::numeric_limits<double>::infinity();
  bool m_stopped = false;
};

}  // namespace sb
