// Which sides of triangles a mesh rises before: flat and convex ones have none, bowls one, folds of
// both kinds both.
#include "techniques/scene/geometry/concave_sides.h"

#include <gtest/gtest.h>

#include <cmath>

#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/scenes/procedural/procedural.h"

using namespace sb;

namespace {

/// Corners of a unit square strip folded along z = const lines: heights at x = 0, 1, 2, ...
Mesh strip(const std::vector<float>& heights) {
  Mesh mesh;
  for (size_t i = 0; i < heights.size(); ++i)
    for (const float z : {0.0f, 1.0f}) mesh.positions.push_back({float(i), heights[i], z});
  for (uint32_t i = 0; i + 1 < heights.size(); ++i) {
    const uint32_t a = 2 * i;
    // Counter-clockwise from above.
    for (const uint32_t v : {a, a + 1, a + 3, a, a + 3, a + 2}) mesh.indices.push_back(v);
  }
  return mesh;
}

std::vector<uint8_t> all(size_t triangles, uint8_t bits) {
  return std::vector<uint8_t>(triangles, bits);
}

std::vector<uint8_t> sidesOf(const Mesh& mesh) { return concaveSides(mesh).ofTriangle; }

/// Every triangle with corners of its own: as glTF files with flat normals have it.
Mesh exploded(const Mesh& mesh) {
  Mesh out;
  for (const uint32_t i : mesh.indices) {
    out.indices.push_back(uint32_t(out.positions.size()));
    out.positions.push_back(mesh.positions[i]);
  }
  return out;
}

}  // namespace

TEST(ConcaveSides, FlatMeshesHaveNone) {
  EXPECT_EQ(sidesOf(strip({0, 0, 0, 0})), all(6, 0));
  EXPECT_EQ(sidesOf(strip({0, 0.1f, 0.2f, 0.3f})), all(6, 0));  // rounded heights
  // Far from the origin positions are rounded more.
  Mesh far = strip({0, 0.25f, 0.5f, 0.75f});
  for (glm::vec3& p : far.positions) p = p * 0.001f + glm::vec3(100, 50, 25);
  EXPECT_EQ(sidesOf(far), all(6, 0));
}

TEST(ConcaveSides, ConvexSolidsHaveThemInside) {
  Scene scene;
  addBox(scene, add(scene, matte()), {-1, -2, -3}, {1, 2, 3});
  EXPECT_EQ(sidesOf(scene.meshes[0]), all(12, kConcaveBack));
}

TEST(ConcaveSides, ValleysAndRidges) {
  EXPECT_EQ(sidesOf(strip({1, 0, 1})), all(4, kConcaveFront));
  EXPECT_EQ(sidesOf(strip({0, 1, 0})), all(4, kConcaveBack));
  // A valley and a ridge: the slope between has both.
  const std::vector<uint8_t> bits = sidesOf(strip({1, 0, 1, 0}));
  EXPECT_EQ(bits[0], kConcaveFront);
  EXPECT_EQ(bits[2], kConcaveFront | kConcaveBack);
  EXPECT_EQ(bits[4], kConcaveBack);
}

TEST(ConcaveSides, WindingTurnsSides) {
  Mesh mesh = strip({1, 0, 1});
  std::swap(mesh.indices[1], mesh.indices[2]);
  EXPECT_EQ(sidesOf(mesh),
            (std::vector<uint8_t>{kConcaveBack, kConcaveFront, kConcaveFront, kConcaveFront}));
}

TEST(ConcaveSides, CornersNeedNoSharedVertices) {
  EXPECT_EQ(sidesOf(exploded(strip({1, 0, 1}))), all(4, kConcaveFront));
}

TEST(ConcaveSides, TessellatedWallsAreAsOneQuad) {
  // A floor of three parts and a wall of three: the parts beyond the corner's neighbours too.
  Mesh corner = strip({0, 0, 0, 0});
  const uint32_t base = 6;
  for (const float y : {1.0f, 2.0f, 3.0f})
    for (const float z : {0.0f, 1.0f}) corner.positions.push_back({3, y, z});
  for (uint32_t a = base; a + 3 < corner.positions.size(); a += 2)
    for (const uint32_t v : {a, a + 1, a + 3, a, a + 3, a + 2}) corner.indices.push_back(v);
  EXPECT_EQ(sidesOf(corner), all(12, kConcaveFront));
}

TEST(ConcaveSides, FineBowlsAreBowls) {
  std::vector<float> heights;
  for (int i = 0; i <= 512; ++i)
    heights.push_back(1024 - std::sqrt(1024 * 1024 - float((i - 256) * (i - 256))));
  EXPECT_EQ(sidesOf(strip(heights)), all(1024, kConcaveFront));
}

TEST(ConcaveSides, DegenerateTrianglesCountForNothing) {
  Mesh mesh = strip({0, 0, 0});
  for (const uint32_t v : {0u, 0u, 1u, 0u, 1u, 1u}) mesh.indices.push_back(v);
  EXPECT_EQ(sidesOf(mesh), all(6, 0));
  EXPECT_TRUE(sidesOf(Mesh{}).empty());
}

TEST(ConcaveSides, ConvexSolidsRiseInLightsWithinAlone) {
  Scene scene;
  place(scene, addBox(scene, add(scene, matte()), {-1, -1, -1}, {1, 1, 1}), translation({5, 0, 0}));
  const ConcaveSides box = concaveSides(scene.meshes[0]);
  EXPECT_TRUE(box.any);
  EXPECT_TRUE(box.convexSolid);
  const auto rises = [&](const Light& light) {
    scene.lights = {light};
    return risesInLight(scene, 1, box);
  };
  EXPECT_FALSE(rises(sun({0.5, -1, 0})));
  EXPECT_FALSE(rises(pointLight({0, 0, 0})));
  EXPECT_TRUE(rises(pointLight({5, 0.5, 0})));
  // Without a face it is open, and the sun may look in.
  Mesh open = scene.meshes[0];
  open.indices.resize(30);
  open.triangleKeys.resize(10);
  EXPECT_FALSE(concaveSides(open).convexSolid);
  scene.lights = {sun({0, -1, 0})};
  EXPECT_TRUE(risesInLight(scene, 1, concaveSides(open)));
}
