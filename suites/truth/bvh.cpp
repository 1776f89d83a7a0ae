#include "suites/truth/bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "suites/truth/watertight.h"

namespace sb {
namespace {

/// One ray's search: tests triangles and keeps what the judge says.
class Search {
 public:
  Search(const std::vector<TruthTriangle>& triangles, const TruthRay& ray, const Bvh::Judge& judge,
         std::vector<TruthHit>& out)
      : m_triangles(triangles),
        m_ray(ray),
        m_sheared(ray.origin, ray.direction),
        m_judge(judge),
        m_out(out) {
    out.clear();
  }

  void test(uint32_t index) {
    if (m_stopped || index == m_ray.own) return;
    const auto hit = intersect(m_sheared, m_triangles[index].corners);
    if (!hit || !(hit->t > m_ray.tMin) || !(hit->t < m_ray.tMax) || hit->t > m_nearest) return;
    const TruthHit found{hit->t, hit->b, hit->c, index, hit->front};
    const Bvh::Verdict verdict = m_judge(found);
    if (verdict == Bvh::Verdict::Ignore) return;
    if (verdict == Bvh::Verdict::Stop) {
      m_stopped = true;
      m_out = {found};
      return;
    }
    if (verdict == Bvh::Verdict::Nearest) m_nearest = std::min(m_nearest, hit->t + m_ray.tie);
    m_out.push_back(found);
  }

  void finish() {
    if (m_out.size() < 2) return;
    std::ranges::sort(m_out, {}, [](const TruthHit& h) { return std::tuple(h.t, h.triangle); });
    std::erase_if(m_out, [&](const TruthHit& h) { return h.t > m_nearest; });
  }

  const ShearedRay<double>& sheared() const { return m_sheared; }
  bool stopped() const { return m_stopped; }
  double nearest() const { return m_nearest; }

 private:
  const std::vector<TruthTriangle>& m_triangles;
  const TruthRay& m_ray;
  const ShearedRay<double> m_sheared;
  const Bvh::Judge& m_judge;
  std::vector<TruthHit>& m_out;
  double m_nearest = std::numeric_limits<double>::infinity();
  bool m_stopped = false;
};

double marginOf(const std::vector<TruthTriangle>& triangles, double reach) {
  double extent = reach;
  for (const TruthTriangle& t : triangles)
    for (const glm::dvec3& p : t.corners)
      extent = std::max(extent, std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
  // Half an ulp of the origin, and of the direction over twice the extent: 2^-22 of the extent; four
  // times that.
  return extent * 0x1p-20;
}

/// Directions are told by their components over the largest one. Smaller shares than this move
/// nothing by a margin within the scene.
constexpr double kLeastShare = 1e-18;

float inverseOf(double share) {
  return float(1 / std::copysign(std::max(std::abs(share), kLeastShare), share));
}

}  // namespace

Bvh::Bvh(const std::vector<TruthTriangle>& triangles, double reach)
    : m_triangles(triangles), m_margin(marginOf(triangles, reach)), m_tree(triangles, m_margin) {}

void Bvh::hits(const TruthRay& ray, const Judge& judge, std::vector<TruthHit>& out,
               BoxWalk walk) const {
  Search search(m_triangles, ray, judge, out);
  if (m_tree.empty()) return;
  const ShearedRay<double>& sheared = search.sheared();
  struct Context {
    Search& search;
    double length;  ///< of the ray's direction: its largest component
    double margin;
    /// Boxes that begin behind what ends the ray need not be entered.
    float end(double t) const { return float(t * length * (1 + 1e-5) + margin); }
  } context{search, std::abs(ray.direction[sheared.kz]), 2 * m_margin};
  WalkRay query{.end = context.end(ray.tMax),
                .kx = sheared.kx,
                .ky = sheared.ky,
                .kz = sheared.kz,
                .ox = sheared.ox,
                .oy = sheared.oy,
                .oz = sheared.oz,
                .sx = sheared.sx,
                .sy = sheared.sy};
  for (int axis = 0; axis < 3; ++axis) query.origin[axis] = float(ray.origin[axis]);
  const double side = std::copysign(1, ray.direction[sheared.kz]);
  query.inverse[sheared.kx] = inverseOf(side * sheared.sx);
  query.inverse[sheared.ky] = inverseOf(side * sheared.sy);
  query.inverse[sheared.kz] = float(side);
  walk(m_tree.view(), query,
       [](void* self, uint32_t triangle, float end) {
         const Context& c = *static_cast<const Context*>(self);
         c.search.test(triangle);
         if (c.search.stopped()) return -1.0f;
         return std::isfinite(c.search.nearest()) ? std::min(end, c.end(c.search.nearest())) : end;
       },
       &context);
  search.finish();
}

void Bvh::hitsOfAll(const std::vector<TruthTriangle>& triangles, const TruthRay& ray,
                    const Judge& judge, std::vector<TruthHit>& out) {
  Search search(triangles, ray, judge, out);
  for (uint32_t i = 0; i < triangles.size(); ++i) search.test(i);
  search.finish();
}

void Bvh::hitsOf(const std::vector<TruthTriangle>& triangles, std::span<const uint32_t> among,
                 const TruthRay& ray, const Judge& judge, std::vector<TruthHit>& out) {
  Search search(triangles, ray, judge, out);
  for (const uint32_t i : among) search.test(i);
  search.finish();
}

}  // namespace sb
