#include "techniques/volumes/edges/edge_mesh.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <span>

#include "techniques/scene/geometry/mesh_edges.h"

namespace sb {
namespace {

glm::dvec3 cornerOf(const Mesh& mesh, uint32_t triangle, uint32_t corner) {
  return mesh.positions[mesh.indices[3 * size_t(triangle) + corner]];
}

uint32_t packed(const EdgeSide& side) { return 2 * side.triangle + (side.forward ? 1 : 0); }

/// Records of the sides of one edge.
void addEdge(std::span<const EdgeSide> sides, EdgeMesh& out) {
  std::vector<uint32_t> forward, back, order;
  for (const EdgeSide& side : sides) (side.forward ? forward : back).push_back(packed(side));
  const size_t pairs = std::min(forward.size(), back.size());
  for (size_t i = 0; i < pairs; ++i) order.insert(order.end(), {forward[i], back[i]});
  order.insert(order.end(), forward.begin() + std::ptrdiff_t(pairs), forward.end());
  order.insert(order.end(), back.begin() + std::ptrdiff_t(pairs), back.end());
  for (size_t i = 0; i < order.size(); i += 2)
    out.edges.push_back({{sides[0].low, sides[0].high, order[i],
                          i + 1 < order.size() ? order[i + 1] : NO_TRIANGLE}});
  out.closed &= sides.size() == 2 && pairs == 1;
}

/// EdgeMesh::winding of a closed mesh: the signs of what its connected parts enclose.
int windingOf(const Mesh& mesh, const EdgeMesh& edges) {
  std::vector<uint32_t> part(mesh.triangleCount());
  std::iota(part.begin(), part.end(), 0u);
  const auto root = [&](uint32_t t) {
    while (part[t] != t) t = part[t] = part[part[t]];
    return t;
  };
  for (const gpu::EdgeData& e : edges.edges) part[root(e.ends.z >> 1)] = root(e.ends.w >> 1);
  std::vector<double> volume(part.size(), 0.0);
  for (const uint32_t t : edges.triangles) {
    // Relative to a point of the part, so that parts far from zero lose nothing.
    const glm::dvec3 origin = cornerOf(mesh, root(t), 0);
    volume[root(t)] +=
        glm::dot(cornerOf(mesh, t, 0) - origin,
                 glm::cross(cornerOf(mesh, t, 1) - origin, cornerOf(mesh, t, 2) - origin));
  }
  bool outward = true, inward = true;
  for (const uint32_t t : edges.triangles) {
    if (root(t) != t) continue;
    outward &= volume[t] > 0;
    inward &= volume[t] < 0;
  }
  return outward ? 1 : inward ? -1 : 0;
}

std::vector<uint32_t> castingTriangles(const Mesh& mesh, Doubles doubles) {
  const std::vector<uint32_t> weld = weldedVertices(mesh.positions);
  std::set<std::array<uint32_t, 3>> known;
  std::vector<uint32_t> triangles;
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
    if (!hasArea(mesh, t)) continue;
    std::array<uint32_t, 3> corners;
    for (size_t c = 0; c < 3; ++c) corners[c] = weld[mesh.indices[3 * size_t(t) + c]];
    std::ranges::sort(corners);
    if (doubles == Doubles::Each || known.insert(corners).second) triangles.push_back(t);
  }
  return triangles;
}

}  // namespace

bool hasArea(const Mesh& mesh, uint32_t triangle) {
  const glm::dvec3 a = cornerOf(mesh, triangle, 0);
  const glm::dvec3 n = glm::cross(cornerOf(mesh, triangle, 1) - a, cornerOf(mesh, triangle, 2) - a);
  return glm::dot(n, n) > 0;
}

EdgeMesh edgeMesh(const Mesh& mesh, Doubles doubles) {
  EdgeMesh out{.edges = {}, .triangles = castingTriangles(mesh, doubles)};
  std::vector<EdgeSide> sides = edgeSides(mesh);
  std::erase_if(sides, [&](const EdgeSide& side) {
    return !std::ranges::binary_search(out.triangles, side.triangle);
  });
  out.closed = !sides.empty();
  for (size_t first = 0, end = 0; first < sides.size(); first = end) {
    while (end < sides.size() && sides[end].low == sides[first].low &&
           sides[end].high == sides[first].high)
      ++end;
    addEdge(std::span(sides).subspan(first, end - first), out);
  }
  if (out.closed) out.winding = windingOf(mesh, out);
  return out;
}

int edgeMultiplicity(const gpu::EdgeData& edge, const std::function<int(uint32_t)>& casts) {
  int m = 0;
  for (const uint32_t side : {edge.ends.z, edge.ends.w})
    if (side != NO_TRIANGLE) m += (side & 1) == 1 ? casts(side >> 1) : -casts(side >> 1);
  return m;
}

}  // namespace sb
