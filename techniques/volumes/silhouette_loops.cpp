#include "techniques/volumes/silhouette_loops.h"

#include <algorithm>
#include <numeric>

namespace sb {
namespace {

/// Triangles that cast, in connected pieces.
class Pieces {
 public:
  Pieces(const Mesh& mesh, const EdgeMesh& edges, const Silhouette& silhouette)
      : m_casts(mesh.triangleCount()), m_of(mesh.triangleCount()) {
    std::iota(m_of.begin(), m_of.end(), 0u);
    for (const uint32_t t : silhouette[VOLUME_CAPS]) m_casts[t] = 1;
    for (const uint32_t t : silhouette[VOLUME_TURNED]) m_casts[t] = -1;
    // Where both sides of an edge cancel, what casts goes on across it.
    for (const gpu::EdgeData& e : edges.edges)
      if (signOf(e.ends.z) != 0 && signOf(e.ends.z) == -signOf(e.ends.w))
        m_of[root(e.ends.z >> 1)] = root(e.ends.w >> 1);
  }

  uint32_t root(uint32_t t) {
    while (m_of[t] != t) t = m_of[t] = m_of[m_of[t]];
    return t;
  }
  /// Of the side along an edge that is needed; `second`: of the same edge.
  uint32_t ofSide(const gpu::EdgeData& e, bool second) {
    const bool atFirst = signOf(e.ends.z) != 0 && !(second && signOf(e.ends.w) != 0);
    return root((atFirst ? e.ends.z : e.ends.w) >> 1);
  }

 private:
  int signOf(uint32_t side) const {
    if (side == NO_TRIANGLE) return 0;
    return (side & 1) == 1 ? m_casts[side >> 1] : -m_casts[side >> 1];
  }

  std::vector<int> m_casts;
  std::vector<uint32_t> m_of;
};

}  // namespace

std::vector<SilhouetteLoop> sortByLoops(const Mesh& mesh, const EdgeMesh& edges,
                                        Silhouette& silhouette) {
  Pieces pieces(mesh, edges, silhouette);
  std::map<uint32_t, SilhouetteLoop> loops;  // by root
  for (uint32_t part = 0; part < VOLUME_PARTS; ++part) {
    std::vector<uint32_t>& items = silhouette[part];
    std::vector<std::pair<uint32_t, uint32_t>> sorted;  // root, item
    for (size_t i = 0; i < items.size(); ++i) {
      const bool second = i > 0 && items[i] == items[i - 1];
      sorted.emplace_back(part == VOLUME_SIDES ? pieces.ofSide(edges.edges[items[i] >> 1], second)
                                               : pieces.root(items[i]),
                          items[i]);
    }
    std::ranges::stable_sort(sorted, {}, &std::pair<uint32_t, uint32_t>::first);
    for (uint32_t i = 0; i < sorted.size(); ++i) {
      items[i] = sorted[i].second;
      ItemRange& range = loops[sorted[i].first][part];
      if (range.count++ == 0) range.first = i;
    }
  }
  std::vector<SilhouetteLoop> all;
  for (const auto& [_, loop] : loops) all.push_back(loop);
  return all;
}

}  // namespace sb
