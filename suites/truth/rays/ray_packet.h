// Rays that walk through the tree together: Bvh::hits of many.
#pragma once

#include "suites/truth/rays/ray_search.h"

namespace sb {

/// Rays that follow one another. A search begins when a triangle is found that a ray's line meets:
/// most shadow rays never meet one.
template <class Rays>
class RayPacket {
 public:
  RayPacket(const Bvh& bvh, Rays& rays, Bvh::PacketHits& hits, const BoxWalks& walks)
      : m_bvh(bvh), m_rays(rays), m_hits(hits), m_walks(walks) {}

  /// Walks with `count` rays from `first` on, kPacket at most.
  void walk(size_t first, uint32_t count) {
    m_first = first;
    m_begun = m_packet.rays = m_packet.unasked = m_packet.stopped = 0;
    for (uint32_t r = 0; r < count; ++r) add(m_rays.ray(first + r), r);
    if (!m_bvh.m_tree.empty())
      m_walks.packet(
          m_bvh.m_tree.view(), m_packet,
          [](void* self, uint32_t r, uint32_t triangle) {
            return static_cast<RayPacket*>(self)->test(r, triangle);
          },
          this);
    for (uint32_t r = 0; r < count; ++r) {
      bool stopped = m_packet.stopped >> r & 1;
      if (m_begun >> r & 1) {
        m_searches[r].finish();
        stopped |= m_searches[r].stopped();
      } else {
        m_hits[r].clear();
      }
      m_rays.end(first + r, stopped, m_hits[r]);
    }
  }

 private:
  void add(const TruthRay& ray, uint32_t r) {
    for (int axis = 0; axis < 3; ++axis) {
      m_packet.origin[axis][r] = ray.origin[axis];
      m_packet.direction[axis][r] = ray.direction[axis];
    }
    m_packet.tMax[r] = ray.tMax;
    m_packet.own[r] = ray.own;
    // Without a direction it meets nothing.
    m_packet.rays |= uint32_t(ray.direction != glm::dvec3(0)) << r;
    m_packet.unasked |= uint32_t(ray.stopsUnasked) << r;
  }
  double test(uint32_t r, uint32_t triangle) {
    RaySearch& search = m_searches[r];
    if (!(m_begun >> r & 1)) {
      search = RaySearch(m_bvh.m_triangles, m_rays.ray(m_first + r), m_hits[r]);
      m_begun |= 1u << r;
    }
    search.test(triangle, [&](const TruthHit& hit) { return m_rays.judge(m_first + r, hit); });
    return search.walkTo();
  }

  const Bvh& m_bvh;
  Rays& m_rays;
  Bvh::PacketHits& m_hits;
  const BoxWalks& m_walks;
  std::array<RaySearch, kPacket> m_searches;
  WalkPacket m_packet{};  ///< walks compute with the places without a ray, too
  size_t m_first;
  uint32_t m_begun;  ///< a bit for each whose line met a triangle
};

template <class Rays>
void Bvh::hits(size_t count, Rays& rays, PacketHits& scratch, const BoxWalks& walks) const {
  RayPacket<Rays> packet(*this, rays, scratch, walks);
  for (size_t first = 0; first < count; first += kPacket)
    packet.walk(first, uint32_t(std::min<size_t>(kPacket, count - first)));
}

}  // namespace sb
