#include "suites/truth/rays/bvh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "suites/truth/rays/ray_search.h"

namespace sb {
namespace {

double marginOf(const std::vector<TruthTriangle>& triangles, double reach) {
  double extent = reach;
  for (const TruthTriangle& t : triangles)
    for (const glm::dvec3& p : t.corners)
      extent = std::max(extent, std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}));
  // Half an ulp of the origin, and of the direction over twice the extent: 2^-22 of the extent;
  // four times that.
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
    // To the sun all rays run alike.
    if (!m_heading.isThatOf(ray.direction)) m_heading = Heading(ray.direction);
    RaySearch& search = m_searches[m_count];
    search.begin(m_triangles, ray, m_heading, m_margin, m_packet.lines[m_count], hits);
    m_numbers[m_count] = number;
    for (int axis = 0; axis < 3; ++axis) {
      m_packet.origin[axis][m_count] = float(ray.origin[axis]);
      m_packet.inverse[axis][m_count] = m_heading.inverse[axis];
    }
    m_packet.end[m_count] = search.end();
    if (++m_count == kPacket) walk();
  }
  /// Walks with those that were added.
  void walk() {
    if (m_count == 0) return;
    for (uint32_t r = m_count; r < kPacket; ++r) {
      for (int axis = 0; axis < 3; ++axis) {
        m_packet.origin[axis][r] = m_packet.origin[axis][0];
        m_packet.inverse[axis][r] = m_packet.inverse[axis][0];
      }
      m_packet.end[r] = -1;
    }
    m_walks.packet(
        m_tree.view(), m_packet,
        [](void* self, uint32_t ray, uint32_t triangle, float before) {
          Packet& p = *static_cast<Packet*>(self);
          RaySearch& search = p.m_searches[ray];
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
  std::array<RaySearch, kPacket> m_searches;
  std::array<size_t, kPacket> m_numbers;
  WalkPacket m_packet;
  Heading m_heading;  ///< of the last one
  uint32_t m_signs = 0;
  uint32_t m_count = 0;
};

}  // namespace

Bvh::Bvh(const std::vector<TruthTriangle>& triangles, double reach)
    : m_triangles(triangles), m_margin(marginOf(triangles, reach)), m_tree(triangles, m_margin) {}

void Bvh::hits(const TruthRay& ray, const Judge& judge, std::vector<TruthHit>& out,
               const BoxWalks& walks) const {
  struct Context {
    RaySearch search;
    const Judge& judge;
  } context{{}, judge};
  const Heading heading(ray.direction);
  WalkRay walked;
  context.search.begin(m_triangles, ray, heading, m_margin, walked.line, out);
  if (m_tree.empty()) return;
  for (int axis = 0; axis < 3; ++axis) {
    walked.origin[axis] = float(ray.origin[axis]);
    walked.inverse[axis] = heading.inverse[axis];
  }
  walked.end = context.search.end();
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
  RaySearch search;
  WalkLine line;
  search.begin(triangles, ray, Heading(ray.direction), 0, line, out);
  for (uint32_t i = 0; i < triangles.size(); ++i)
    if (i != ray.own) search.test(i, judge);
  search.finish();
}

}  // namespace sb
