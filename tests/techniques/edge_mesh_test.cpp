// Edges of meshes (spec 07): worked examples, soups, closed chains for any of them.
#include "techniques/volumes/edges/edge_mesh.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/scenes/procedural/procedural.h"
#include "techniques/draw/scene/storage_window.h"

namespace sb::test {
namespace {

Mesh boxMesh() {
  Scene scene;
  addBox(scene, add(scene, matte()), {-1, -1, -1}, {1, 1, 1});
  return scene.meshes.front();
}

Mesh soup(const std::vector<glm::vec3>& corners) {
  Mesh mesh;
  mesh.positions = corners;
  for (uint32_t i = 0; i < corners.size(); ++i) mesh.indices.push_back(i);
  return mesh;
}

/// 1 where a triangle faces a light, else 0; ties are back-facing.
std::function<int(uint32_t)> facing(const Mesh& mesh, glm::dvec4 light) {
  return [&mesh, light](uint32_t t) {
    const auto corner = [&](uint32_t c) {
      return glm::dvec3(mesh.positions[mesh.indices[3 * size_t(t) + c]]);
    };
    const glm::dvec3 n = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
    return glm::dot(n, glm::dvec3(light) - light.w * corner(0)) > 0 ? 1 : 0;
  };
}

int sidesOf(const EdgeMesh& edges, const std::function<int(uint32_t)>& casts) {
  int sides = 0;
  for (const gpu::EdgeData& e : edges.edges) sides += std::abs(edgeMultiplicity(e, casts));
  return sides;
}

/// Sides leave every vertex as often as they reach it.
bool isClosedChain(const EdgeMesh& edges, const std::function<int(uint32_t)>& casts) {
  std::map<uint32_t, int> sum;
  for (const gpu::EdgeData& e : edges.edges) {
    const int m = edgeMultiplicity(e, casts);
    sum[e.ends.x] += m;
    sum[e.ends.y] -= m;
  }
  for (const auto& [vertex, m] : sum)
    if (m != 0) return false;
  return true;
}

TEST(EdgeMesh, ACubeWithTheLightAboveHasFourContourEdges) {
  const Mesh box = boxMesh();  // 24 vertices: faces share none
  const EdgeMesh edges = edgeMesh(box);
  EXPECT_TRUE(edges.closed);
  EXPECT_EQ(edges.edges.size(), 18u);  // 12, and 6 diagonals
  EXPECT_EQ(sidesOf(edges, facing(box, {0, 0, 5, 1})), 4);
  EXPECT_EQ(sidesOf(edges, facing(box, {5, 5, 5, 1})), 6);
  EXPECT_EQ(sidesOf(edges, facing(box, {0, 0, 1, 0})), 4);
  // In the plane of a face: that one does not face it.
  EXPECT_EQ(sidesOf(edges, facing(box, {0, 5, 1, 1})), 4);
  for (const gpu::EdgeData& e : edges.edges) EXPECT_LT(e.ends.x, e.ends.y);
}

TEST(EdgeMesh, ThreeTrianglesAtOneEdge) {
  // Two go from a to b, one from b to a: one side is needed (spec 07).
  const glm::vec3 a(0, 0, 0), b(1, 0, 0);
  const Mesh mesh = soup({a, b, {0, 1, 1}, a, b, {0, 1, 0.5f}, b, a, {0, -1, 1}});
  const EdgeMesh edges = edgeMesh(mesh);
  int m = 0;
  for (const gpu::EdgeData& e : edges.edges)
    if (e.ends.x == 0 && e.ends.y == 1) m += edgeMultiplicity(e, [](uint32_t) { return 1; });
  EXPECT_EQ(m, 1);
  EXPECT_FALSE(edges.closed);
  // Turned over, it goes the other way.
  EXPECT_EQ(sidesOf(edges, [](uint32_t) { return 1; }),
            sidesOf(edges, [](uint32_t) { return -1; }));
}

TEST(EdgeMesh, OpenEdgesDuplicatesAndTrianglesWithoutArea) {
  const glm::vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_EQ(sidesOf(edgeMesh(soup({a, b, c})), [](uint32_t) { return 1; }), 3);
  // Two surfaces are two.
  EXPECT_EQ(sidesOf(edgeMesh(soup({a, b, c, a, b, c})), [](uint32_t) { return 1; }), 6);
  EXPECT_TRUE(edgeMesh(soup({a, b, b, a, b, {2, 0, 0}})).edges.empty());
  EXPECT_FALSE(edgeMesh(soup({a, b, b})).closed);
}

TEST(EdgeMesh, DoubledTrianglesMayCastOnce) {
  const glm::vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  const auto all = [](uint32_t) { return 1; };
  // As wound, from another corner, turned over.
  const Mesh mesh = soup({a, b, c, b, c, a, a, c, b});
  EXPECT_EQ(sidesOf(edgeMesh(mesh, Doubles::Once), all), 3);
  EXPECT_EQ(edgeMesh(mesh, Doubles::Once).triangles, std::vector<uint32_t>{0});
  EXPECT_EQ(edgeMesh(mesh).triangles, (std::vector<uint32_t>{0, 1, 2}));
  Mesh box = boxMesh();
  const std::vector<uint32_t> once = box.indices;
  box.indices.insert(box.indices.end(), once.begin(), once.end());
  EXPECT_FALSE(edgeMesh(box).closed);
  EXPECT_TRUE(edgeMesh(box, Doubles::Once).closed);
  EXPECT_EQ(edgeMesh(box, Doubles::Once).winding, 1);
}

TEST(EdgeMesh, SidesAreAClosedChainForAnySoup) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(-1, 1);
  std::uniform_int_distribution<int> grid(-1, 1);
  for (int round = 0; round < 50; ++round) {
    std::vector<glm::vec3> corners;
    // On a coarse grid triangles share vertices, edges and planes, and some have no area.
    for (int i = 0; i < 90; ++i) corners.push_back({grid(random), grid(random), grid(random)});
    const Mesh mesh = soup(corners);
    const EdgeMesh edges = edgeMesh(mesh);
    const auto facesLight = facing(mesh, {unit(random), unit(random), unit(random), 1});
    EXPECT_TRUE(isClosedChain(edges, facesLight)) << round;
    EXPECT_TRUE(isClosedChain(edges, [&](uint32_t t) { return facesLight(t) ? 1 : -1; })) << round;
  }
}

TEST(EdgeMesh, ContoursOfClosedMeshesHaveOneSideAnEdge) {
  const Scene scene = makeScene("teapot");
  for (const Mesh& mesh : scene.meshes) {
    const EdgeMesh edges = edgeMesh(mesh);
    const auto casts = facing(mesh, {3, 4, 5, 1});
    EXPECT_TRUE(isClosedChain(edges, casts));
    if (!edges.closed) continue;
    for (const gpu::EdgeData& e : edges.edges) EXPECT_LE(std::abs(edgeMultiplicity(e, casts)), 1);
  }
}

TEST(StorageWindows, StartAtAlignedPlacesAndFitTheDevice) {
  rhi::Limits limits;
  limits.storageAlignment = 64;
  limits.maxStorageRange = 1000;
  const StorageWindow window = storageWindow(limits, 6, rhi::BufferId{1}, 200, 300);
  EXPECT_EQ(window.binding.offset, 192u);
  EXPECT_EQ(window.binding.size, 308u);
  EXPECT_EQ(window.first, 2u);
  EXPECT_NO_THROW(storageWindow(limits, 6, rhi::BufferId{1}, 1u << 30, 1000));
  EXPECT_THROW(storageWindow(limits, 6, rhi::BufferId{1}, 4, 1000), rhi::Error);
}

}  // namespace
}  // namespace sb::test
