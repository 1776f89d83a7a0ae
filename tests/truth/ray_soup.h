// Triangles and rays that are hard to tell apart from near misses.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "suites/scenes/procedural/parts/random.h"
#include "suites/truth/rays/ray_packet.h"

namespace sb::test {

using glm::dvec3;

inline dvec3 randomPoint(Pcg& random, double size) {
  auto u = [&] { return (2 * random.uniform() - 1) * size; };
  const double x = u(), y = u(), z = u();
  return {x, y, z};
}

/// Random triangles of all sizes, with duplicates, slivers and points.
inline std::vector<TruthTriangle> soup(size_t count, double scale, uint64_t seed) {
  Pcg random(seed);
  std::vector<TruthTriangle> list;
  for (uint32_t i = 0; i < count; ++i) {
    const dvec3 at = randomPoint(random, scale);
    const double size = scale * std::pow(10.0, -3 * random.uniform());
    TruthTriangle t{.instance = i, .number = 0};
    for (auto& corner : t.corners) corner = at + randomPoint(random, size);
    if (i % 17 == 3 && i > 0) t.corners = list.back().corners;
    if (i % 19 == 4) t.corners[2] = t.corners[1];
    if (i % 23 == 5) t.corners[1] = (t.corners[0] + t.corners[2]) * 0.5;
    if (i % 29 == 6) t.corners[2] = t.corners[1] + (t.corners[0] - t.corners[1]) * (1 + 1e-15);
    list.push_back(t);
  }
  return list;
}

/// Squares of two triangles in the planes of a grid: corners, edges and planes meet exactly, and
/// boxes are as flat as they come.
inline std::vector<TruthTriangle> grid(int size) {
  std::vector<TruthTriangle> list;
  for (int axis = 0; axis < 3; ++axis)
    for (int k = -size; k <= size; ++k)
      for (int u = -size; u < size; ++u)
        for (int v = -size; v < size; ++v) {
          auto at = [&](int du, int dv) {
            dvec3 p(0);
            p[axis] = k, p[(axis + 1) % 3] = u + du, p[(axis + 2) % 3] = v + dv;
            return p;
          };
          list.push_back({.corners = {at(0, 0), at(1, 0), at(1, 1)}});
          list.push_back({.corners = {at(0, 0), at(1, 1), at(0, 1)}});
        }
  return list;
}

/// A ray that ends nowhere ends there.
constexpr double kForever = std::numeric_limits<double>::infinity();

inline std::vector<BoxWalks> allWalks() {
  std::vector<BoxWalks> walks = {baselineWalks()};
  if (hasAvx2()) walks.push_back(avx2Walks());
  return walks;
}

/// Rays that walk together, and what they met.
class RaysTogether {
 public:
  RaysTogether(std::span<const TruthRay> rays, Bvh::Judge judge)
      : hits(rays.size()),
        stopped(rays.size()),
        ended(rays.size()),
        m_rays(rays),
        m_judge(std::move(judge)) {}
  void find(const Bvh& bvh, const BoxWalks& walks) {
    Bvh::PacketHits scratch;
    bvh.hits(m_rays.size(), *this, scratch, walks);
  }

  std::vector<std::vector<TruthHit>> hits;
  std::vector<bool> stopped;
  std::vector<uint32_t> ended;  ///< how often each was

  // As Bvh asks for them.
  TruthRay ray(size_t i) const { return m_rays[i]; }
  Bvh::Verdict judge(size_t, const TruthHit& hit) { return m_judge(hit); }
  void end(size_t i, bool stops, std::vector<TruthHit>& found) {
    hits[i].swap(found);
    stopped[i] = stops;
    ++ended[i];
  }

 private:
  std::span<const TruthRay> m_rays;
  Bvh::Judge m_judge;
};

inline bool same(const std::vector<TruthHit>& a, const std::vector<TruthHit>& b) {
  return std::ranges::equal(a, b, [](const TruthHit& x, const TruthHit& y) {
    return x.t == y.t && x.b == y.b && x.c == y.c && x.triangle == y.triangle && x.front == y.front;
  });
}

}  // namespace sb::test
