// Which surfaces rays pass, which light reaches which side, where the truth jumps, and what lies
// around a lookup.
#include <gtest/gtest.h>

#include <cmath>

#include "suites/scenes/procedural/parts/shapes.h"
#include "tests/truth/traced.h"

namespace sb::test {
namespace {

using glm::dvec3;

size_t at(uint32_t x, uint32_t y) { return y * 64u + x; }
float red(const Truth& t, uint32_t layer, uint32_t x, uint32_t y) {
  return t.visibility[layer][4 * at(x, y)];
}
float asked(const Truth& t, uint32_t layer, uint32_t x, uint32_t y) {
  return t.visibility[layer][4 * at(x, y) + 3];
}

/// A mask whose left half is cut out: alpha from a texture of two texels.
Material halfMask(Scene& scene) {
  scene.images.push_back(
      {.name = "mask", .width = 2, .height = 1, .rgba = {255, 255, 255, 0, 255, 255, 255, 255}});
  Material m = matte();
  m.alphaMode = AlphaMode::Mask;
  m.baseColorTexture.image = uint32_t(scene.images.size() - 1);
  m.baseColorTexture.nearest = true;
  m.baseColorTexture.wrapU = Wrap::ClampToEdge;
  return m;
}

TEST(TruthSurfaces, HolesOfAMaskPassLightAndSight) {
  Scene scene = floorScene();
  Mesh quad = quadMesh(add(scene, halfMask(scene)), {0, 0.25f, 0}, {0, 0, 2}, {2, 0, 0});
  quad.uv0.clear();
  for (const glm::vec3& p : quad.positions) quad.uv0.push_back({p.x / 4 + 0.5f, 0.5f});
  place(scene, add(scene, quad));
  const Truth t = traced(scene);
  // Left of the middle light and sight pass; right of it the mask is the first opaque surface.
  EXPECT_EQ(red(t, 0, 24, 32), 1);
  EXPECT_EQ(t.surfaces[1][at(24, 32)], 1);
  EXPECT_EQ(red(t, 0, 40, 32), 1) << "the mask itself is lit";
  scene.cameras[0] = downCamera({0, 0.125, 0}, 4, 8);  // from below the mask
  const Truth below = traced(scene);
  EXPECT_EQ(red(below, 0, 24, 32), 1);
  EXPECT_EQ(red(below, 0, 40, 32), 0);
}

TEST(TruthSurfaces, ColoursOfVerticesLetPassWhatTheyDoWhereTheyAre) {
  Scene scene = floorScene();
  Material pane = matte();
  pane.alphaMode = AlphaMode::Blend;
  pane.baseColor = {0, 0, 0, 0.8f};
  Mesh quad = quadMesh(add(scene, pane), {0, 0.25f, 0}, {0, 0, 2}, {2, 0, 0});
  for (const glm::vec3& p : quad.positions) quad.colors.push_back({1, 1, 1, p.x / 4 + 0.5f});
  place(scene, add(scene, quad));
  const Truth t = traced(scene);
  const float left = red(t, 0, 24, 32), right = red(t, 0, 39, 32);
  EXPECT_GT(left, right + 0.1f);
  EXPECT_NEAR(left + right, 2 - 0.8, 1e-5);
}

TEST(TruthSurfaces, TexturesLetPassWhatTheyDoWhereTheyAre) {
  Scene scene = floorScene();
  Material pane = halfMask(scene);
  pane.alphaMode = AlphaMode::Blend;
  Mesh quad = quadMesh(add(scene, pane), {0, 0.25f, 0}, {0, 0, 2}, {2, 0, 0});
  quad.uv0.clear();
  for (const glm::vec3& p : quad.positions) quad.uv0.push_back({p.x / 4 + 0.5f, 0.5f});
  place(scene, add(scene, quad));
  const Truth t = traced(scene);
  EXPECT_EQ(red(t, 0, 24, 32), 1);
  EXPECT_LT(red(t, 0, 40, 32), 0.9f);
}

TEST(TruthSurfaces, WhatLiesInOnePlaneAsFarAsFloatsTellDoesNotShadow) {
  Scene scene;
  const uint32_t material = add(scene, matte());
  addHorizontal(scene, material, {0, 1, 0}, 4, 4);
  addHorizontal(scene, material, {0, std::nextafter(1.0f, 2.0f), 0}, 4, 4);
  scene.cameras.push_back(downCamera({0, 1.5, 0}, 4, 8));
  addLight(scene, sun({0, -1, 0}));
  const Truth t = traced(scene);
  const Tracer tracer(scene, 64, 64);
  EXPECT_EQ(tracer.pointAt(24, 32, 0)->instance, 0u) << "the lower one is the first of both";
  EXPECT_EQ(red(t, 0, 24, 32), 1);
}

TEST(TruthSurfaces, BackFacesAreSeenOnlyOfDoubleSidedAndTranslucentSurfaces) {
  for (const int kind : {0, 1, 2}) {
    Scene scene = floorScene();
    Material m = kind == 2 ? glass(0.5f, glm::vec3(0.5f)) : matte();
    m.doubleSided = kind == 1;
    // Normal downward: its back is toward the camera.
    addQuad(scene, add(scene, m), {0, 0.25f, 0}, {2, 0, 0}, {0, 0, 2});
    const Truth t = traced(scene);
    EXPECT_EQ(t.surfaces[1][at(32, 32)], kind == 2 ? 2 : 1);
    EXPECT_EQ(t.surfaces[2][at(32, 32)], kind == 2 ? 1 : 0);
    // Light meets both sides: through a single-sided quad that is not seen, the floor is dark.
    if (kind == 0) {
      EXPECT_EQ(red(t, 0, 32, 32), 0);
    }
  }
}

TEST(TruthSurfaces, VisibilityIsAskedOnlyWhereLightArrives) {
  Scene scene = floorScene(false);
  addLight(scene, sun({0, 1, 0}));                           // from below
  addLight(scene, spotLight({0, 2, 0}, {0, -1, 0}, 0.4));    // a cone of radius 0.85
  Light near = pointLight({0, 1, 0});
  near.range = 1.5;
  addLight(scene, near);
  const Truth t = traced(scene);
  EXPECT_EQ(asked(t, 0, 32, 32), 0);
  EXPECT_EQ(asked(t, kTruthLayers, 32, 32), 1);
  EXPECT_EQ(asked(t, kTruthLayers, 48, 32), 0);
  EXPECT_EQ(asked(t, 2 * kTruthLayers, 36, 32), 1);
  EXPECT_EQ(asked(t, 2 * kTruthLayers, 48, 32), 0);
}

TEST(TruthSurfaces, CoplanarDuplicatesDoNotShadow) {
  Scene scene = floorScene();
  addHorizontal(scene, 0, {0, 0, 0}, 4, 4);
  const Truth t = traced(scene);
  for (uint32_t y = 0; y < 64; ++y)
    for (uint32_t x = 0; x < 64; ++x) ASSERT_EQ(red(t, 0, x, y), 1) << x << " " << y;
}

TEST(TruthSurfaces, EdgesAreWhereTheShadowEndsAndNowhereElse) {
  Scene scene = floorScene();
  addHorizontal(scene, 0, {0, 1, 0}, 1, 1);  // shadow over pixels 24..39
  const Truth t = traced(scene);
  EXPECT_EQ(red(t, 0, 32, 32), 0);
  EXPECT_EQ(red(t, 0, 10, 32), 1);
  const auto& edges = t.edges[0];
  for (uint32_t x = 0; x < 64; ++x) {
    // The edge lies on a pixel border: the pixels on both sides see it at none of their positions
    // or at some, and two more belong to it.
    const bool far = x < 20 || (x > 28 && x < 35) || x > 43;
    if (far) {
      EXPECT_EQ(edges[at(x, 32)], 0) << x;
    }
  }
  scene.instances[1].toWorld[3].x += 0.05;  // off the pixel grid
  const Truth off = traced(scene);
  for (const uint32_t x : {22u, 24u, 26u, 38u, 40u, 42u}) EXPECT_EQ(off.edges[0][at(x, 32)], 1) << x;
  EXPECT_EQ(off.imageEdges[at(24, 32)], 1);
  EXPECT_EQ(off.imageEdges[at(32, 32)], 0);
}

TEST(TruthSurfaces, AroundALookup) {
  Scene scene = floorScene();
  addHorizontal(scene, 0, {2, 1, 0}, 1, 1);  // its shadow begins at x = 1
  addLight(scene, pointLight({0, 2, 0}));
  const Tracer tracer(scene, 64, 64);
  const auto point = tracer.pointAt(36, 32, 0);  // x = 0.5625
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->position.x, 0.5625, 1e-12);
  EXPECT_EQ(point->normal, dvec3(0, 1, 0));
  const auto narrow = tracer.visibilityNear(0, *point, {.constant = 0.4});
  EXPECT_EQ(narrow.low, dvec3(1));
  const auto wide = tracer.visibilityNear(0, *point, {.constant = 0.5});
  EXPECT_EQ(wide.low, dvec3(0));
  EXPECT_EQ(wide.high, dvec3(1));
  // A lookup's width is a unit of two coordinates, whatever the kind of light.
  const auto other = tracer.pointAt(40, 32, 0);  // 0.5 to the right
  for (const uint32_t light : {0u, 1u}) {
    const LookupReach reach = light == 0 ? LookupReach{.constant = 0.25}
                                         : LookupReach{.perDistance = 0.125};
    const dvec3 step = tracer.mapCoordinates(light, *other, reach) -
                       tracer.mapCoordinates(light, *point, reach);
    EXPECT_NEAR(std::max(std::abs(step.x), std::abs(step.y)), 2, 1e-9) << light;
    EXPECT_EQ(step.z, 0);
  }
}

/// A gutter along z with walls of slope 4 under a sun straight above, seen from there; `lid`: a strip
/// a little above its right half.
Scene gutterScene(bool lid) {
  Scene scene;
  Mesh gutter;
  gutter.material = add(scene, matte());
  gutter.positions = {{-1, 4, -1}, {-1, 4, 1}, {0, 0, 1}, {0, 0, -1}, {1, 4, -1}, {1, 4, 1}};
  gutter.normals.assign(6, {0, 1, 0});
  gutter.indices = {0, 1, 2, 0, 2, 3, 3, 2, 5, 3, 5, 4};
  place(scene, add(scene, std::move(gutter)));
  if (lid) addHorizontal(scene, 0, {0.5, 4.5, 0}, 0.5f, 1);
  addLight(scene, sun({0, -1, 0}));
  Camera camera = lookAt({0, 10, 0}, {0, 0, 0}, 0.25, 20);
  camera.orthographic = true;
  camera.halfHeight = 1;
  scene.cameras = {camera};
  return scene;
}

TEST(TruthSurfaces, WhereTheReceiverBendsUpwardsIsNoShadowsEdge) {
  for (const bool lid : {false, true}) {
    const Scene scene = gutterScene(lid);
    const Tracer tracer(scene, 64, 64);
    const auto point = tracer.pointAt(30, 32, 0);  // x = -0.047, on the left wall
    ASSERT_TRUE(point);
    ASSERT_LT(point->position.x, 0);
    const auto range = tracer.visibilityNear(0, *point, {.constant = 0.25});
    EXPECT_EQ(range.low, dvec3(lid ? 0 : 1)) << lid;
    EXPECT_EQ(range.high, dvec3(1)) << lid;
  }
}

}  // namespace
}  // namespace sb::test
