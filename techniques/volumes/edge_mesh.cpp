#include "techniques/volumes/edge_mesh.h"

#include <algorithm>
#include <span>

#include "techniques/scene/geometry/mesh_edges.h"

namespace sb {
namespace {

bool hasArea(const Mesh& mesh, uint32_t triangle) {
  const auto corner = [&](uint32_t c) {
    return glm::dvec3(mesh.positions[mesh.indices[3 * size_t(triangle) + c]]);
  };
  const glm::dvec3 n = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
  return glm::dot(n, n) > 0;
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

}  // namespace

EdgeMesh edgeMesh(const Mesh& mesh) {
  std::vector<EdgeSide> sides = edgeSides(mesh);
  std::erase_if(sides, [&](const EdgeSide& side) { return !hasArea(mesh, side.triangle); });
  EdgeMesh out{.edges = {}, .closed = !sides.empty()};
  for (size_t first = 0, end = 0; first < sides.size(); first = end) {
    while (end < sides.size() && sides[end].low == sides[first].low &&
           sides[end].high == sides[first].high)
      ++end;
    addEdge(std::span(sides).subspan(first, end - first), out);
  }
  return out;
}

int edgeMultiplicity(const gpu::EdgeData& edge, const std::function<int(uint32_t)>& casts) {
  int m = 0;
  for (const uint32_t side : {edge.ends.z, edge.ends.w})
    if (side != NO_TRIANGLE) m += (side & 1) == 1 ? casts(side >> 1) : -casts(side >> 1);
  return m;
}

}  // namespace sb
