#include "techniques/scene/geometry/mesh_edges.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <tuple>
#include <unordered_map>

namespace sb {
namespace {

struct PositionHash {
  size_t operator()(const std::array<uint32_t, 3>& p) const {
    uint64_t h = 0;
    for (const uint32_t bits : p) h = (h ^ bits) * 0x9E3779B97F4A7C15ull, h ^= h >> 29;
    return size_t(h);
  }
};

}  // namespace

std::vector<uint32_t> weldedVertices(const std::vector<glm::vec3>& positions) {
  std::unordered_map<std::array<uint32_t, 3>, uint32_t, PositionHash> first;
  first.reserve(positions.size());
  std::vector<uint32_t> out(positions.size());
  for (uint32_t i = 0; i < positions.size(); ++i) {
    const glm::vec3 p = positions[i] + 0.0f;  // -0 is 0
    std::array<uint32_t, 3> bits;
    std::memcpy(bits.data(), &p, sizeof bits);
    out[i] = first.try_emplace(bits, i).first->second;
  }
  return out;
}

std::vector<EdgeSide> edgeSides(const Mesh& mesh) {
  const std::vector<uint32_t> weld = weldedVertices(mesh.positions);
  std::vector<EdgeSide> sides;
  sides.reserve(mesh.indices.size());
  for (uint32_t t = 0; t < mesh.triangleCount(); ++t)
    for (uint32_t c = 0; c < 3; ++c) {
      const uint32_t a = weld[mesh.indices[3 * t + c]];
      const uint32_t b = weld[mesh.indices[3 * t + (c + 1) % 3]];
      if (a != b)
        sides.push_back(
            {std::min(a, b), std::max(a, b), t, weld[mesh.indices[3 * t + (c + 2) % 3]], a < b});
    }
  std::ranges::sort(sides, [](const EdgeSide& a, const EdgeSide& b) {
    return std::tuple(a.low, a.high, a.triangle) < std::tuple(b.low, b.high, b.triangle);
  });
  return sides;
}

}  // namespace sb
