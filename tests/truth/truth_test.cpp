// The truth on scenes that are worked out by hand (spec 16: worked example, product rule, validation
// 3-5; spec 15's compositing; spec 17, G10), and that nothing but the scene decides it.
#include "suites/truth/truth.h"

#include <gtest/gtest.h>

#include "suites/scenes/edit/transform.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/scenes/procedural/procedural.h"
#include "tests/truth/traced.h"

namespace sb::test {
namespace {

using glm::dvec3;

/// RGB of a light's visibility at a pixel of a layer; x, y from the lower left.
dvec3 visibilityAt(const Truth& t, uint32_t light, uint32_t layer, uint32_t x, uint32_t y) {
  const float* v = t.visibility[light * kTruthLayers + layer].data() + 4 * (y * t.width + x);
  EXPECT_EQ(v[3], 1) << "layer " << layer << " at " << x << ", " << y;
  return {v[0], v[1], v[2]};
}

TEST(Truth, WorkedExampleOfTwoPanes) {
  Scene scene = floorScene(false);
  addLight(scene, pointLight({0, 4, 0}));
  addHorizontal(scene, add(scene, glass(0.8f, {0.9f, 0.3f, 0.3f})), {0, 2, 0}, 2, 2);
  addHorizontal(scene, add(scene, glass(0.5f, {0.2f, 0.8f, 0.2f})), {0, 1, 0}, 2, 2);
  scene.cameras[0] = downCamera({0, 3, 0}, 4, 8);
  const Truth t = traced(scene);
  expectNear(visibilityAt(t, 0, 0, 32, 32), {0.552, 0.396, 0.264}, 1e-6, "floor");
  expectNear(visibilityAt(t, 0, 3, 32, 32), {0.552, 0.396, 0.264}, 1e-6, "floor as third layer");
  expectNear(visibilityAt(t, 0, 2, 32, 32), {0.92, 0.44, 0.44}, 1e-6, "lower pane");
  EXPECT_EQ(visibilityAt(t, 0, 1, 32, 32), dvec3(1)) << "upper pane";
  EXPECT_EQ(t.surfaces[1][32 * 64 + 32], 2);
  EXPECT_EQ(t.surfaces[0][32 * 64 + 32], 1);
  EXPECT_EQ(t.surfaces[4][32 * 64 + 32], 0);
  EXPECT_EQ(t.standardError, 0);
}

TEST(Truth, LayersMultiply) {
  const float alphas[] = {0.3f, 0.6f, 0.9f, 0.45f};
  const glm::vec3 ts[] = {{0.9f, 0.1f, 0.5f}, {0.3f, 0.7f, 0.2f}, {1, 0, 0.25f}, {0, 1, 0.75f}};
  Scene scene = floorScene();
  dvec3 product(1);
  for (int i = 0; i < 4; ++i) {
    addHorizontal(scene, add(scene, glass(alphas[i], ts[i])), {0, 1.0f + float(i), 0}, 3, 3);
    product *= 1.0 - double(alphas[i]) * (1.0 - dvec3(ts[i]));
  }
  const Tracer tracer(scene, 64, 64);
  const auto point = tracer.pointAt(20, 40, 0);
  ASSERT_TRUE(point);
  expectNear(tracer.visibility(0, *point), product, 1e-12, "product rule");
}

TEST(Truth, AlphaAndTransmissionOfZeroAndOneAreExact) {
  const float grid[4][3] = {{0, 0, 1}, {0, 1, 1}, {1, 0, 0}, {1, 1, 1}};
  for (const auto& [alpha, t, expected] : grid) {
    Scene scene = floorScene();
    addHorizontal(scene, add(scene, glass(alpha, glm::vec3(t))), {0, 1, 0}, 3, 3);
    EXPECT_EQ(visibilityAt(traced(scene, 16), 0, 0, 8, 8), dvec3(expected)) << alpha << " " << t;
  }
}

TEST(Truth, CameraLayersCompositeInTheirOrder) {
  // Spec 15: (1,0,0) and (0,1,0), both a = .5, over (0,0,1): (.5,.25,.25); reversed (.25,.5,.25).
  for (const bool reversed : {false, true}) {
    Scene scene;
    auto unlit = [&](glm::vec3 color, float alpha) {
      Material m = glass(alpha, glm::vec3(0));
      m.baseColor = glm::vec4(color, 1);
      m.unlit = true;
      return add(scene, m);
    };
    addHorizontal(scene, unlit({0, 0, 1}, 1), {0, 0, 0}, 4, 4);
    addHorizontal(scene, unlit(reversed ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0), 0.5f), {0, 1, 0},
                  4, 4);
    addHorizontal(scene, unlit(reversed ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0), 0.5f), {0, 2, 0},
                  4, 4);
    scene.cameras.push_back(downCamera({0, 3, 0}, 4, 8));
    const Truth t = traced(scene, 8);
    const float* c = t.image.data() + 4 * (4 * 8 + 4);
    EXPECT_EQ(c[0], reversed ? 0.25f : 0.5f);
    EXPECT_EQ(c[1], reversed ? 0.5f : 0.25f);
    EXPECT_EQ(c[2], 0.25f);
  }
}

TEST(Truth, DoesNotDependOnThePlaceInTheWorld) {
  Scene scene = makeScene("layers");
  const Truth here = traced(scene);
  translateScene(scene, {1e7, -1e7, 1e7});
  const Truth there = traced(scene);
  size_t differ = 0;
  for (size_t i = 0; i < here.visibility.size(); ++i)
    for (size_t k = 0; k < here.visibility[i].size(); ++k)
      differ += std::abs(here.visibility[i][k] - there.visibility[i][k]) > 1e-6f;
  EXPECT_EQ(differ, 0u);
  for (size_t k = 0; k < here.image.size(); ++k)
    ASSERT_NEAR(here.image[k], there.image[k], 1e-6f) << k;
}

TEST(Truth, DoesNotDependOnTheNumberOfThreads) {
  const Scene scene = makeScene("teapot");
  const Truth one = traced(scene, 64, 1);
  for (const unsigned threads : {0u, 2u}) {
    const Truth more = traced(scene, 64, threads);
    EXPECT_EQ(one.visibility, more.visibility);
    EXPECT_EQ(one.image, more.image);
    EXPECT_EQ(one.edges, more.edges);
    EXPECT_EQ(one.rays, more.rays);
  }
}

TEST(Truth, TheImageAloneIsTheImageOfTheTruth) {
  const Scene scene = makeScene("layers");
  const Tracer tracer(scene, 61, 45);  // no whole number of tiles
  uint64_t rays = 0;
  EXPECT_EQ(tracer.image(1, &rays), tracer.trace({.width = 61, .height = 45})->image);
  EXPECT_GE(rays, 61u * 45u);
}

TEST(Truth, AnInterruptGivesUp) {
  const std::atomic<bool> interrupted = true;
  const Scene scene = makeScene("layers");
  EXPECT_FALSE(Tracer(scene, 16, 16).trace({.width = 16, .height = 16, .interrupted = &interrupted}));
}

}  // namespace
}  // namespace sb::test
