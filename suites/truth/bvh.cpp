#include "suites/truth/bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

#include "suites/truth/watertight.h"

namespace sb {
namespace {

/// One ray's search: tests triangles and keeps what the judge says.
class Search {
 public:
  Search(const std::vector<TruthTriangle>& triangles, const TruthRay& ray,
         std::vector<TruthHit>& out)
      : m_triangles(triangles), m_ray(ray), m_sheared(ray.origin, ray.direction), m_out(out) {
    out.clear();
  }

  template <class Judge>
  void test(uint32_t index, const Judge& judge) {
    if (m_stopped || index == m_ray.own) return;
    const auto hit = intersect(m_sheared, m_triangles[index].corners);
    if (!hit || !(hit->t > m_ray.tMin) || !(hit->t < m_ray.tMax) || hit->t > m_nearest) return;
    const TruthHit found{hit->t, hit->b, hit->c, index, hit->front};
    const Bvh::Verdict verdict = judge(found);
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

  /// As the tree's walks take it. `margin`: that of the tree.
  WalkRay walked(double margin) {
    m_length = std::abs(m_ray.direction[m_sheared.kz]);
    m_slack = 2 * margin;
    WalkRay ray{.end = end(m_ray.tMax),
                .kx = m_sheared.kx,
                .ky = m_sheared.ky,
                .kz = m_sheared.kz,
                .ox = m_sheared.ox,
                .oy = m_sheared.oy,
                .oz = m_sheared.oz,
                .sx = m_sheared.sx,
                .sy = m_sheared.sy,
                .own = m_ray.own};
    for (int axis = 0; axis < 3; ++axis) ray.origin[axis] = float(m_ray.origin[axis]);
    const double side = std::copysign(1, m_ray.direction[m_sheared.kz]);
    ray.inverse[m_sheared.kx] = inverseOf(side * m_sheared.sx);
    ray.inverse[m_sheared.ky] = inverseOf(side * m_sheared.sy);
    ray.inverse[m_sheared.kz] = float(side);
    return ray;
  }
  /// How far to walk on, having walked to `before`.
  float walkedEnd(float before) const {
    if (m_stopped) return -1;
    return m_nearest < std::numeric_limits<double>::infinity() ? std::min(before, end(m_nearest))
                                                               : before;
  }

 private:
  /// Directions are told by their components over the largest one. Smaller shares than this move
  /// nothing by a margin within the scene.
  static constexpr double kLeastShare = 1e-18;

  static float inverseOf(double share) {
    return float(1 / std::copysign(std::max(std::abs(share), kLeastShare), share));
  }
  /// Boxes that begin behind need not be entered.
  float end(double t) const { return float(t * m_length * (1 + 1e-5) + m_slack); }

  const std::vector<TruthTriangle>& m_triangles;
  const TruthRay& m_ray;
  const ShearedRay<double> m_sheared;
  std::vector<TruthHit>& m_out;
  double m_length = 0;  ///< of the direction: its largest component
  double m_slack = 0;
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

/// Which of its components are negative.
uint32_t signsOf(const WalkRay& ray) {
  return uint32_t(ray.inverse[0] < 0) | uint32_t(ray.inverse[1] < 0) << 1 |
         uint32_t(ray.inverse[2] < 0) << 2;
}

/// Rays that walk together: neighbours of one another in the order in which they come, with
/// directions of the same signs.
class Packet {
 public:
  Packet(const std::vector<TruthTriangle>& triangles, const BoxTree& tree, double margin,
         const BoxWalks& walks, const Bvh::PacketJudge& judge)
      : m_triangles(triangles), m_tree(tree), m_margin(margin), m_walks(walks), m_judge(judge) {}

  void add(size_t number, const TruthRay& ray, std::vector<TruthHit>& out) {
    Search& search = m_searches[m_count].emplace(m_triangles, ray, out);
    const WalkRay walked = search.walked(m_margin);
    const uint32_t signs = signsOf(walked);
    if (m_count > 0 && signs != m_signs) {
      // Begins the next packet.
      Search first = search;
      walk();
      m_searches[0].emplace(first);
    }
    m_signs = signs;
    m_numbers[m_count] = number;
    for (int axis = 0; axis < 3; ++axis) {
      m_packet.origin[axis][m_count] = walked.origin[axis];
      m_packet.inverse[axis][m_count] = walked.inverse[axis];
    }
    m_packet.end[m_count] = walked.end;
    m_packet.rays[m_count] = walked;
    if (++m_count == kPacket) walk();
  }
  /// Walks with those that were added.
  void walk() {
    if (m_count == 0) return;
    for (uint32_t r = m_count; r < kPacket; ++r) m_packet.end[r] = -1;
    m_walks.packet(
        m_tree.view(), m_packet,
        [](void* self, uint32_t ray, uint32_t triangle, float before) {
          Packet& p = *static_cast<Packet*>(self);
          Search& search = *p.m_searches[ray];
          search.test(triangle,
                      [&](const TruthHit& hit) { return p.m_judge(p.m_numbers[ray], hit); });
          return search.walkedEnd(before);
        },
        this);
    for (uint32_t r = 0; r < m_count; ++r) m_searches[r]->finish();
    m_count = 0;
  }

 private:
  const std::vector<TruthTriangle>& m_triangles;
  const BoxTree& m_tree;
  const double m_margin;
  const BoxWalks& m_walks;
  const Bvh::PacketJudge& m_judge;
  std::array<std::optional<Search>, kPacket> m_searches;
  std::array<size_t, kPacket> m_numbers;
  WalkPacket m_packet{};
  uint32_t m_signs = 0;
  uint32_t m_count = 0;
};

}  // namespace

Bvh::Bvh(const std::vector<TruthTriangle>& triangles, double reach)
    : m_triangles(triangles), m_margin(marginOf(triangles, reach)), m_tree(triangles, m_margin) {}

void Bvh::hits(const TruthRay& ray, const Judge& judge, std::vector<TruthHit>& out,
               const BoxWalks& walks) const {
  struct Context {
    Search search;
    const Judge& judge;
  } context{Search(m_triangles, ray, out), judge};
  if (m_tree.empty()) return;
  walks.ray(
      m_tree.view(), context.search.walked(m_margin),
      [](void* self, uint32_t triangle, float before) {
        Context& c = *static_cast<Context*>(self);
        c.search.test(triangle, c.judge);
        return c.search.walkedEnd(before);
      },
      &context);
  context.search.finish();
}

void Bvh::hits(std::span<const TruthRay> rays, const PacketJudge& judge,
               std::span<std::vector<TruthHit>> out, const BoxWalks& walks) const {
  Packet packet(m_triangles, m_tree, m_margin, walks, judge);
  for (size_t i = 0; i < rays.size(); ++i)
    if (m_tree.empty())
      out[i].clear();
    else
      packet.add(i, rays[i], out[i]);
  packet.walk();
}

void Bvh::hitsOfAll(const std::vector<TruthTriangle>& triangles, const TruthRay& ray,
                    const Judge& judge, std::vector<TruthHit>& out) {
  Search search(triangles, ray, out);
  for (uint32_t i = 0; i < triangles.size(); ++i) search.test(i, judge);
  search.finish();
}

void Bvh::hitsOf(const std::vector<TruthTriangle>& triangles, std::span<const uint32_t> among,
                 const TruthRay& ray, const Judge& judge, std::vector<TruthHit>& out) {
  Search search(triangles, ray, out);
  for (const uint32_t i : among) search.test(i, judge);
  search.finish();
}

}  // namespace sb
