#include "techniques/scene/geometry/concave_sides.h"

#include <algorithm>
#include <numeric>

#include "techniques/scene/geometry/mesh_edges.h"

namespace sb {
namespace {

/// Half-ulps of the largest coordinate that the height of a corner over a plane may be wrong by.
constexpr double kRounding = 8 * 0x1p-24;

/// Sides of triangles, those that go on in one plane united: node 2 t is the front of triangle t.
class Sides {
 public:
  explicit Sides(uint32_t triangles) : m_parent(2 * size_t(triangles)), m_concave(m_parent.size()) {
    std::iota(m_parent.begin(), m_parent.end(), 0);
  }
  void unite(uint32_t a, uint32_t b) { m_parent[root(a)] = root(b); }
  void mark(uint32_t side) { m_concave[side] = 1; }
  /// Bits of each triangle.
  std::vector<uint8_t> bits() {
    for (uint32_t side = 0; side < m_parent.size(); ++side)
      if (m_concave[side]) m_concave[root(side)] = 1;
    std::vector<uint8_t> out(m_parent.size() / 2);
    for (uint32_t t = 0; t < out.size(); ++t)
      out[t] = uint8_t((m_concave[root(2 * t)] ? kConcaveFront : 0) |
                       (m_concave[root(2 * t + 1)] ? kConcaveBack : 0));
    return out;
  }

 private:
  uint32_t root(uint32_t side) {
    while (m_parent[side] != side) side = m_parent[side] = m_parent[m_parent[side]];
    return side;
  }
  std::vector<uint32_t> m_parent;
  std::vector<uint8_t> m_concave;
};

class Finder {
 public:
  explicit Finder(const Mesh& mesh) : m_mesh(mesh), m_sides(mesh.triangleCount()) {
    for (const glm::vec3& p : mesh.positions)
      m_rounding = std::max(
          {m_rounding, std::abs(double(p.x)), std::abs(double(p.y)), std::abs(double(p.z))});
    m_rounding *= kRounding;
  }

  ConcaveSides find() {
    const std::vector<EdgeSide> edges = edgeSides(m_mesh);
    bool closed = !edges.empty();
    for (size_t first = 0, end = 0; first < edges.size(); first = end) {
      while (end < edges.size() && edges[end].low == edges[first].low &&
             edges[end].high == edges[first].high)
        ++end;
      closed &= end == first + 2 && edges[first].forward != edges[first + 1].forward;
      for (size_t i = first; i < end; ++i)
        for (size_t k = first; k < end; ++k)
          if (i != k) meet(edges[i], edges[k]);
    }
    ConcaveSides out{.ofTriangle = m_sides.bits()};
    uint8_t all = 0;
    for (const uint8_t bits : out.ofTriangle) all |= bits;
    out.any = all != 0;
    out.convexSolid = closed && all != (kConcaveFront | kConcaveBack);
    return out;
  }

 private:
  glm::dvec3 at(uint32_t vertex) const { return m_mesh.positions[vertex]; }
  glm::dvec3 normal(uint32_t t) const {
    const uint32_t* i = &m_mesh.indices[3 * size_t(t)];
    return glm::cross(at(i[1]) - at(i[0]), at(i[2]) - at(i[0]));
  }

  void meet(const EdgeSide& a, const EdgeSide& b) {
    const glm::dvec3 n = normal(a.triangle), m = normal(b.triangle);
    const double length = glm::length(n);
    if (!(length > 0) || !(glm::length(m) > 0)) return;
    const double height = glm::dot(n, at(b.opposite) - at(a.low)) / length;
    const uint32_t front = 2 * a.triangle;
    if (height > m_rounding) return m_sides.mark(front);
    if (height < -m_rounding) return m_sides.mark(front + 1);
    const uint32_t other = 2 * b.triangle, turned = glm::dot(n, m) < 0 ? 1 : 0;
    m_sides.unite(front, other + turned);
    m_sides.unite(front + 1, other + 1 - turned);
  }

  const Mesh& m_mesh;
  Sides m_sides;
  double m_rounding = 0;
};

}  // namespace

ConcaveSides concaveSides(const Mesh& mesh) { return Finder(mesh).find(); }

bool risesInLight(const PlacedScene& placed, uint32_t instance, const ConcaveSides& sides) {
  if (!sides.any || !sides.convexSolid) return sides.any;
  const Scene& scene = placed.scene();
  const Mesh& mesh = scene.meshes[scene.instances[instance].mesh];
  const glm::dmat4 toMesh = glm::inverse(placed.toWorld(instance));
  const glm::dvec3 margin = 1e-6 * glm::dvec3(mesh.boundsMax - mesh.boundsMin);
  const auto within = [&](const Light& light) {
    if (light.type == LightType::Directional) return false;
    const glm::dvec3 p(toMesh * glm::dvec4(light.position, 1));
    // Not a number, of a singular transform, is inside too.
    return !glm::any(glm::lessThan(p, glm::dvec3(mesh.boundsMin) - margin)) &&
           !glm::any(glm::greaterThan(p, glm::dvec3(mesh.boundsMax) + margin));
  };
  for (uint32_t l = 0; l < scene.lights.size(); ++l)
    if (within(placed.light(l))) return true;
  return false;
}

}  // namespace sb
