// What the truth must not depend on: how far away the camera stands, which of two surfaces in one
// plane rounding puts in front, on which side of a shared edge a point falls (spec 16, exclusions).
#include <gtest/gtest.h>

#include <cmath>

#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/scenes/procedural/procedural.h"
#include "tests/truth/traced.h"

namespace sb::test {
namespace {

using glm::dvec3;

constexpr uint32_t kSize = 64;

/// A lid a little above the floor under slanted light, seen from `distance` with the same picture.
Scene lidFrom(double distance, float height = 0.0625f) {
  Scene scene;
  addHorizontal(scene, add(scene, matte()), {0, 0, 0}, 4, 4);
  addHorizontal(scene, 0, {0, height, 0}, 0.5f, 0.5f);
  addLight(scene, sun({0.75, -0.25, 0.125}));
  const dvec3 away = glm::normalize(dvec3(0.25, 1, 0.5));
  Camera camera = lookAt(away * distance, {0, 0, 0}, 2 * std::atan(1 / distance), 2 * distance);
  camera.nearPlane = distance / 4;
  scene.cameras = {camera};
  return scene;
}

TEST(TruthCoplanar, TheDistanceOfTheCameraPlaysNoPart) {
  size_t darkAtOnce = 0;
  for (const float height : {0.0625f, 0x1p-10f}) {
    std::vector<size_t> dark;
    // Perspective differs from near; from 1e3 on the views are alike to a thousandth.
    for (const double distance : {1e3, 1e4, 1e5, 1e6, 1e7}) {
      const Truth t = traced(lidFrom(distance, height), 256);
      size_t count = 0;
      for (size_t p = 0; p < t.surfaces[0].size(); ++p)
        count += t.visibility[0][4 * p + 3] == 1 && t.visibility[0][4 * p] == 0;
      dark.push_back(count);
    }
    for (const size_t d : dark) EXPECT_NEAR(double(d), double(dark[0]), 4 + 0.02 * double(dark[0]));
    darkAtOnce = std::max(darkAtOnce, dark[0]);
  }
  EXPECT_GT(darkAtOnce, 200u) << "the lid throws no shadow";
}

/// A tilted parallelogram around a point, of two triangles or of a fan from its middle: the same
/// plane, other triangles.
Mesh tilted(uint32_t material, bool fan) {
  const glm::vec3 u(1, 0.375f, 0.125f), v(0.25f, 0.5f, -1);
  Mesh mesh = quadMesh(material, {0, 1, 0}, u, v);
  if (!fan) return mesh;
  mesh.positions.push_back({0, 1, 0});
  mesh.normals.push_back(mesh.normals[0]);
  mesh.indices = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  return mesh;
}

Scene tiltedPair(Material first, Material second) {
  Scene scene;
  place(scene, add(scene, tilted(add(scene, std::move(first)), false)));
  // Placed by another matrix: the coordinates are rounded elsewhere.
  Mesh fan = tilted(add(scene, std::move(second)), true);
  for (glm::vec3& p : fan.positions) p = p * 0.1f;
  place(scene, add(scene, std::move(fan)),
        glm::dmat4(10, 0, 0, 0, 0, 10, 0, 0, 0, 0, 10, 0, 0, 0, 0, 1));
  addHorizontal(scene, add(scene, matte()), {0, -1, 0}, 6, 6);
  addLight(scene, sun({0.1, -1, 0.05}));
  scene.cameras = {lookAt({2.1, 3.3, 4.7}, {0, 0.5, 0}, 0.6)};
  return scene;
}

TEST(TruthCoplanar, SurfacesInOnePlaneAreLayersInTheOrderOfTheirKeys) {
  const Scene scene = tiltedPair(glass(0.5f, glm::vec3(0)), glass(0.5f, glm::vec3(0.25f)));
  const Tracer tracer(scene, kSize, kSize);
  size_t both = 0, floorBelow = 0;
  for (uint32_t y = 0; y < kSize; ++y)
    for (uint32_t x = 0; x < kSize; ++x) {
      const auto first = tracer.pointAt(x, y, 1), second = tracer.pointAt(x, y, 2);
      if (!first || first->instance == 2) continue;
      ASSERT_TRUE(second);
      ASSERT_EQ(first->instance, 0u) << x << " " << y;
      ASSERT_EQ(second->instance, 1u) << x << " " << y;
      EXPECT_EQ(tracer.visibility(0, *first), dvec3(1)) << "its own plane does not shadow it";
      EXPECT_EQ(tracer.visibility(0, *second), dvec3(1));
      ++both;
    }
  EXPECT_GT(both, 100u);
  for (uint32_t y = 0; y < kSize; ++y)
    for (uint32_t x = 0; x < kSize; ++x)
      if (const auto floor = tracer.pointAt(x, y, 0)) {
        const dvec3 v = tracer.visibility(0, *floor);
        EXPECT_TRUE(v == dvec3(1) || glm::length(v - dvec3(0.5 * 0.625)) < 1e-6) << v.x;
        floorBelow += v != dvec3(1);
      }
  EXPECT_GT(floorBelow, 30u);
}

TEST(TruthCoplanar, ATranslucentSurfaceInAnOpaqueOneIsNoLayer) {
  for (const bool opaqueFirst : {false, true}) {
    const Material pane = glass(0.5f, glm::vec3(0));
    const Truth t = opaqueFirst ? traced(tiltedPair(matte(), pane)) : traced(tiltedPair(pane, matte()));
    for (size_t p = 0; p < t.surfaces[0].size(); ++p) {
      ASSERT_EQ(t.surfaces[1][p] != 0, t.surfaces[0][p] != 0) << p;
      ASSERT_NE(t.surfaces[1][p], 2) << "the pane is a layer";
    }
  }
}

TEST(TruthCoplanar, AHairApartIsApart) {
  Scene scene = floorScene();
  addHorizontal(scene, 0, {0, 0x1p-18f, 0}, 1, 1);
  const Truth t = traced(scene);
  EXPECT_EQ(t.visibility[0][4 * (32 * kSize + 32)], 1);
  scene.cameras[0] = downCamera({0, 0x1p-19, 0}, 4, 8);  // between floor and lid
  EXPECT_EQ(traced(scene).visibility[0][4 * (32 * kSize + 32)], 0);
}

/// Pixels that are dark among lit ones of the same surface.
size_t specklesOf(const Scene& scene, uint32_t size) {
  const Truth t = traced(scene, size);
  size_t speckles = 0;
  for (size_t light = 0; light < scene.lights.size(); ++light) {
    const auto& v = t.visibility[light * kTruthLayers];
    const auto lit = [&](uint32_t x, uint32_t y) {
      const size_t p = size_t(y) * size + x;
      return v[4 * p + 3] == 1 && v[4 * p] == 1;
    };
    for (uint32_t y = 1; y + 1 < size; ++y)
      for (uint32_t x = 1; x + 1 < size; ++x) {
        size_t around = 0;
        for (int k = 0; k < 9; ++k)
          if (k != 4) around += lit(x + uint32_t(k % 3) - 1, y + uint32_t(k / 3) - 1);
        speckles += around == 8 && !lit(x, y) && v[4 * (size_t(y) * size + x) + 3] == 1;
      }
  }
  return speckles;
}

TEST(TruthCoplanar, FacetsOfASmoothMeshDoNotShadowTheirNeighbours) {
  // A ball is convex: where light reaches a facet's front, nothing of the ball is in between.
  for (const double distance : {4.0, 400.0, 4e5}) {
    Scene scene;
    const uint32_t material = add(scene, matte());
    Mesh ball;
    ball.material = material;
    constexpr uint32_t kRings = 24;
    for (uint32_t r = 0; r <= kRings; ++r)
      for (uint32_t s = 0; s < kRings; ++s) {
        const float a = 3.14159265f * float(r) / kRings, b = 6.2831853f * float(s) / kRings;
        ball.positions.push_back({std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b)});
        ball.normals.push_back(ball.positions.back());
        const uint32_t next = r * kRings + (s + 1) % kRings, here = r * kRings + s;
        if (r < kRings)
          for (const uint32_t i : {here, next, here + kRings, next, next + kRings, here + kRings})
            ball.indices.push_back(i);
      }
    place(scene, add(scene, std::move(ball)));
    addLight(scene, sun({0.6, -1, 0.3}));
    addLight(scene, pointLight({0, 1.5, 0}));
    scene.cameras = {lookAt(glm::normalize(dvec3(0.3, 0.6, 1)) * distance, {0, 0, 0},
                            2 * std::atan(1.1 / distance), 2 * distance)};
    scene.cameras[0].nearPlane = distance / 4;
    const Truth t = traced(scene, 128);
    size_t asked = 0;
    for (size_t l = 0; l < 2; ++l)
      for (size_t p = 0; p < t.surfaces[0].size(); ++p) {
        const float* v = t.visibility[l * kTruthLayers].data() + 4 * p;
        asked += v[3] == 1;
        ASSERT_TRUE(v[3] == 0 || v[0] == 1) << "light " << l << " pixel " << p << " at " << distance;
      }
    EXPECT_GT(asked, 4000u);
  }
  EXPECT_EQ(specklesOf(makeScene("teapot"), 192), 0u);
}

TEST(TruthCoplanar, ALightInACeilingShines) {
  Scene scene = floorScene(false);
  addHorizontal(scene, 0, {0, 2.7f, 0}, 3, 3);
  addLight(scene, pointLight({0.3, double(2.7f), 0.1}));
  addLight(scene, pointLight({0.3, double(2.7f) + 0.01, 0.1}));
  const Truth t = traced(scene);
  for (size_t p = 0; p < t.surfaces[0].size(); ++p) {
    ASSERT_EQ(t.visibility[0][4 * p], 1) << p;
    if (p % kSize > 16 && p % kSize < 48 && p / kSize > 16 && p / kSize < 48)
      ASSERT_EQ(t.visibility[kTruthLayers][4 * p], 0) << "above the ceiling: " << p;
  }
}

TEST(TruthCoplanar, TexturesTiledManyTimesStayExact) {
  Scene scene = floorScene();
  scene.images.push_back({.name = "ramp", .width = 2, .height = 1,
                          .rgba = {0, 0, 0, 255, 255, 255, 255, 255}});
  Material m = matte(glm::vec3(1));
  m.unlit = true;
  m.baseColorTexture.image = 0;
  Mesh quad = quadMesh(add(scene, m), {0, 0.25f, 0}, {0, 0, 3.7f}, {3.7f, 0, 0});
  for (const glm::vec3& p : quad.positions) quad.uv0.push_back({(p.x / 3.7f + 1) * 150, 0.5f});
  place(scene, add(scene, quad));
  const Truth t = traced(scene);
  for (uint32_t x = 4; x < 60; ++x) {
    const double at = (x + 0.5) / kSize * 8 - 4;
    double u = (at / double(3.7f) + 1) * 150;
    u -= std::floor(u);
    const double expected = u < 0.25 ? 0.5 - 2 * u : u < 0.75 ? 2 * u - 0.5 : 2.5 - 2 * u;
    EXPECT_NEAR(t.image[4 * (32 * kSize + x)], expected, 1e-6) << x;
  }
}

}  // namespace
}  // namespace sb::test
