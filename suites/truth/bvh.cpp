#include "suites/truth/bvh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "suites/truth/watertight.h"

namespace sb {
namespace {

/// One ray's search: tests triangles and keeps what the judge says.
class Search {
 public:
  /// In place: what is copied right after it was written, the CPU waits for. `alike`: a search in
  /// the same direction, if there is one; its heading is taken over.
  void begin(const std::vector<TruthTriangle>& triangles, const TruthRay& ray,
             std::vector<TruthHit>& out, const Search* alike = nullptr) {
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
    if (m_stopped || index == m_ray->own) return;
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
  void takeHeading(const Search& other) {
    m_sheared = other.m_sheared;
    m_length = other.m_length;
    std::ranges::copy(other.m_inverse, m_inverse);
  }
  /// Components that are smaller shares of the largest one move nothing by a margin within the scene.
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
uint32_t signsOf(const glm::dvec3& d) {
  return uint32_t(std::signbit(d.x)) | uint32_t(std::signbit(d.y)) << 1 |
         uint32_t(std::signbit(d.z)) << 2;
}

/// Rays that walk together: neighbours of one another in the order in which they come, with
/// directions of the same signs.
class Packet {
 public:
  Packet(const std::vector<TruthTriangle>& triangles, const BoxTree& tree, double margin,
         const BoxWalks& walks, const Bvh::PacketJudge& judge)
      : m_triangles(triangles), m_tree(tree), m_margin(margin), m_walks(walks), m_judge(judge) {}

  void add(size_t number, const TruthRay& ray, std::vector<TruthHit>& hits) {
    const uint32_t signs = signsOf(ray.direction);
    if (signs != m_signs) walk();
    m_signs = signs;
    WalkRay& out = m_packet.rays[m_count];
    // To the sun all rays run alike.
    const bool alike = m_count > 0 && ray.direction == m_direction;
    m_direction = ray.direction;
    m_searches[m_count].begin(m_triangles, ray, hits, alike ? &m_searches[m_count - 1] : nullptr);
    m_searches[m_count].setOut(m_margin, out);
    m_numbers[m_count] = number;
    for (int axis = 0; axis < 3; ++axis) {
      m_packet.origin[axis][m_count] = out.origin[axis];
      m_packet.inverse[axis][m_count] = out.inverse[axis];
    }
    m_packet.end[m_count] = out.end;
    if (++m_count == kPacket) walk();
  }
  /// Walks with those that were added.
  void walk() {
    if (m_count == 0) return;
    for (uint32_t r = m_count; r < kPacket; ++r) {
      for (int axis = 0; axis < 3; ++axis)
        m_packet.origin[axis][r] = 0, m_packet.inverse[axis][r] = 1;
      m_packet.end[r] = -1;
    }
    m_walks.packet(
        m_tree.view(), m_packet,
        [](void* self, uint32_t ray, uint32_t triangle, float before) {
          Packet& p = *static_cast<Packet*>(self);
          Search& search = p.m_searches[ray];
          search.test(triangle,
                      [&](const TruthHit& hit) { return p.m_judge(p.m_numbers[ray], hit); });
          return search.walkedEnd(before);
        },
        this);
    for (uint32_t r = 0; r < m_count; ++r) m_searches[r].finish();
    m_count = 0;
  }

 private:
  const std::vector<TruthTriangle>& m_triangles;
  const BoxTree& m_tree;
  const double m_margin;
  const BoxWalks& m_walks;
  const Bvh::PacketJudge& m_judge;
  std::array<Search, kPacket> m_searches;
  std::array<size_t, kPacket> m_numbers;
  WalkPacket m_packet;
  glm::dvec3 m_direction = glm::dvec3(0);  ///< of the last one
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
  } context{{}, judge};
  context.search.begin(m_triangles, ray, out);
  if (m_tree.empty()) return;
  WalkRay walked;
  context.search.setOut(m_margin, walked);
  walks.ray(
      m_tree.view(), walked,
      [](void* self, uint32_t triangle, float before) {
        Context& c = *static_cast<Context*>(self);
        c.search.test(triangle, c.judge);
        return c.search.walkedEnd(before);
      },
      &context);
  context.search.finish();
}

void Bvh::hits(std::span<const TruthRay* const> rays, const PacketJudge& judge,
               std::span<std::vector<TruthHit>> out, const BoxWalks& walks) const {
  Packet packet(m_triangles, m_tree, m_margin, walks, judge);
  for (size_t i = 0; i < rays.size(); ++i)
    if (m_tree.empty())
      out[i].clear();
    else
      packet.add(i, *rays[i], out[i]);
  packet.walk();
}

void Bvh::hitsOfAll(const std::vector<TruthTriangle>& triangles, const TruthRay& ray,
                    const Judge& judge, std::vector<TruthHit>& out) {
  Search search;
  search.begin(triangles, ray, out);
  for (uint32_t i = 0; i < triangles.size(); ++i) search.test(i, judge);
  search.finish();
}

}  // namespace sb
