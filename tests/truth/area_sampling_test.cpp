// Lights with an extent in the truth: where one ray is exact, what sampling may miss and depend on
// (spec 16, validation 5), and what counts as an edge.
#include <gtest/gtest.h>

#include "suites/scenes/edit/transform.h"
#include "suites/truth/truth_cache.h"
#include "tests/truth/area_scenes.h"

namespace sb::test {
namespace {

using glm::dvec3;

TEST(TruthArea, NothingBetweenIsExactForEveryShape) {
  for (Light light : {sphere({1, 3, 0}, 1), areaLight({0, 3, 0}, LightShape::Disc, {1, 1, 0}),
                      areaLight({0, 3, 0}, LightShape::Rectangle, {2, 1, 0})}) {
    Scene scene = under(light);
    const auto t = *Tracer(scene, 16, 16).trace({.width = 16, .height = 16});
    EXPECT_EQ(t.standardError, 0);
    EXPECT_EQ(t.rays, 16u * 16 * 5 * 2) << "one to the eye and one to the light";
    for (size_t p = 0; p < 256; ++p) ASSERT_EQ(t.visibility[0][4 * p], 1.0f);
  }
}

TEST(TruthArea, WhatHidesAllOfTheLightIsExact) {
  Scene scene = under(areaLight({0, 4, 0}, LightShape::Disc, {0.5, 0.5, 0}));
  // Two triangles; receivers near x + z = 0 see their common edge.
  addHorizontal(scene, add(scene, glass(0.5f, {0, 0.5f, 1})), {0, 2, 0}, 1000, 1000);
  const Tracer tracer(scene, 16, 16);
  Tracer::Point point{.position = dvec3(2, 0, 1) - dvec3(0, 0.5, 0),
                      .normal = dvec3(0, 1, 0),
                      .instance = 0,
                      .triangle = 0,
                      .translucent = false};
  EXPECT_EQ(tracer.visibility(0, point), dvec3(0.5, 0.75, 1));
  const Truth t = *tracer.trace({.width = 16, .height = 16});
  EXPECT_EQ(t.visibility[0][4 * (16 * 3 + 2)], 0.5f);
  addHorizontal(scene, add(scene, matte()), {0, 3, 0}, 1000, 1000);
  EXPECT_EQ(shareAt(scene, 2, 1), 0);
}

TEST(TruthArea, HolesInWhatHidesAllOfTheLightAreLookedThrough) {
  // A perforated sheet that covers the light, one half of it open: its edge halves the light,
  // though no triangle's edge does.
  Scene scene = under(areaLight({0, 4, 0}, LightShape::Disc, {0.5, 0.5, 0}));
  scene.images.push_back(
      {.name = "half", .width = 2, .height = 1, .rgba = {255, 255, 255, 255, 255, 255, 255, 0}});
  Material perforated = matte();
  perforated.alphaMode = AlphaMode::Mask;
  perforated.baseColorTexture.image = 0;
  perforated.baseColorTexture.nearest = true;
  perforated.baseColorTexture.wrapU = Wrap::ClampToEdge;
  Mesh sheet = quadMesh(add(scene, perforated), {0, 2, 0}, {0, 0, 1000}, {1000, 0, 0});
  sheet.uv0.clear();
  for (const glm::vec3& p : sheet.positions) sheet.uv0.push_back({p.x / 2000 + 0.5f, 0.5f});
  place(scene, add(scene, sheet));
  const double left = shareAt(scene, -0.25, 0.5), right = shareAt(scene, 0.25, 0.5);
  EXPECT_NEAR(std::min(left, right), segment(0.5), kExpected);
  EXPECT_NEAR(left + right, 1, 2 * kExpected);
}

TEST(TruthArea, WithinTheLightNothingIsDefined) {
  Scene scene = under(sphere({0, 0.1, 0}, 1));
  addStrip(scene, 0.05, 0, 1000);
  const Truth t = *Tracer(scene, 16, 16).trace({.width = 16, .height = 16});
  const size_t middle = 8 * 16 + 7, corner = 0;
  EXPECT_EQ(t.visibility[0][4 * middle + 3], 0) << "excluded";
  EXPECT_EQ(t.visibility[0][4 * corner + 3], 1);
  EXPECT_EQ(t.imageEdges[middle], 1);
}

TEST(TruthArea, ALampInTheCeilingIsNotShadowedByIt) {
  Scene scene = under(areaLight({0.3, 4, 0.1}, LightShape::Rectangle, {0.7, 0.3, 0}));
  addStrip(scene, 4, -1000, 1000);
  const Tracer tracer(scene, 16, 16);
  for (int i = 0; i < 32; ++i) {
    EXPECT_EQ(shareAt(tracer, 0.123 * i, 0.456), 1) << i;
    EXPECT_EQ(shareAt(tracer, 0.123 * i, 0.456, {.pattern = 16}), 1) << i;
  }
  const Truth t = *tracer.trace({.width = 16, .height = 16});
  EXPECT_EQ(t.rays, 16u * 16 * 5 * 2) << "it is not between: one ray to the eye, one to the light";
}

TEST(TruthArea, WhatFewSamplesMissIsFound) {
  // A few thousandths of the disc: 256 samples may all pass them by, and agree.
  for (const double edge : {0.96, 0.965, 0.97, 0.975}) {
    Scene scene = under(areaLight({0, 4, 0}, LightShape::Disc, {1, 1, 0}));
    addStrip(scene, 2, edge / 2, 1000);
    EXPECT_NEAR(shareAt(scene, 0, 0), 1 - segment(edge), 1.5e-3) << edge;
  }
}

Scene penumbra() {
  Scene scene = under(sphere({0.5, 4, 0.2}, 0.7));
  addHorizontal(scene, add(scene, matte()), {0, 2, 0}, 0.6f, 0.8f);
  addHorizontal(scene, add(scene, glass(0.6f, {0.9f, 0.3f, 0.1f})), {0.4f, 1, 0.5f}, 0.9f, 0.5f);
  return scene;
}

TEST(TruthArea, TheErrorIsBelowWhatIsAsked) {
  const Truth t = *Tracer(penumbra(), 24, 24).trace({.width = 24, .height = 24});
  EXPECT_GT(t.standardError, 0);
  EXPECT_LT(t.standardError, 5e-4);
  const Truth fine =
      *Tracer(penumbra(), 24, 24).trace({.width = 24, .height = 24, .sampling = {.error = 5e-5}});
  EXPECT_LT(fine.standardError, t.standardError);
  EXPECT_GT(fine.rays, 2 * t.rays);
  // The estimate is to be believed.
  double squares = 0;
  size_t sampled = 0;
  for (size_t k = 0; k < t.visibility[0].size(); ++k) {
    const double off = double(t.visibility[0][k]) - double(fine.visibility[0][k]);
    ASSERT_LT(std::abs(off), 6 * 5e-4) << k;
    squares += off * off;
    sampled += off != 0;
  }
  EXPECT_GT(sampled, 300u);
  EXPECT_LT(std::sqrt(squares / double(sampled)), 5e-4);
}

TEST(TruthArea, DependsOnNeitherThreadsNorPlace) {
  Scene scene = penumbra();
  const auto trace = [&](unsigned threads) {
    return *Tracer(scene, 24, 24, threads).trace({.width = 24, .height = 24});
  };
  const Truth one = trace(1), two = trace(2);
  EXPECT_EQ(one.visibility, two.visibility);
  EXPECT_EQ(one.image, two.image);
  EXPECT_EQ(one.rays, two.rays);
  EXPECT_EQ(one.standardError, two.standardError);
  translateScene(scene, {1e7, -1e7, 1e7});
  const Truth there = trace(0);
  for (size_t k = 0; k < one.visibility[0].size(); ++k)
    ASSERT_NEAR(one.visibility[0][k], there.visibility[0][k], 1e-6f) << k;
}

TEST(TruthArea, PenumbraeAreNoEdgesAndContactsAre) {
  const auto edges = [](double radius, double height) {
    Scene scene = under(sphere({0, 6, 0}, radius));
    addStrip(scene, height, 0.03, 1000);
    const Truth t = *Tracer(scene, 64, 64).trace({.width = 64, .height = 64});
    size_t count = 0;
    for (size_t x = 16; x < 48; ++x) count += t.edges[0][32 * 64 + x];
    return count;
  };
  EXPECT_EQ(edges(1, 2), 0u) << "a penumbra of a dozen pixels";
  EXPECT_GE(edges(0, 2), 4u) << "hard";
  EXPECT_GE(edges(0.001, 2), 4u) << "a penumbra of a hundredth of a pixel";
}

TEST(TruthArea, APatternTakesAsManyRaysAndConverges) {
  const Scene scene = penumbra();
  const Tracer tracer(scene, 32, 32);
  const Truth exact = *tracer.trace({.width = 32, .height = 32});
  double last = HUGE_VAL;
  for (const uint32_t rays : {1u, 16u, 256u}) {
    const Truth t = *tracer.trace({.width = 32, .height = 32, .sampling = {.pattern = rays}});
    double sum = 0;
    for (size_t k = 0; k < t.visibility[0].size(); ++k) {
      const double off = double(t.visibility[0][k]) - double(exact.visibility[0][k]);
      sum += off * off;
    }
    EXPECT_LT(sum, 0.25 * last) << rays;
    last = sum;
    uint64_t count = 0;
    const auto image = tracer.image(rays, &count);
    EXPECT_EQ(image, t.image);
    EXPECT_GE(count, uint64_t(rays) * 900);
  }
  // One ray goes to the centre: hard shadows.
  Scene hard = scene;
  hard.lights[0].shape = LightShape::Point;
  EXPECT_EQ(tracer.image(1), Tracer(hard, 32, 32).image(1));
}

TEST(TruthArea, SamplingIsPartOfTheKey) {
  const std::string key = truthKey("s", 8, 8);
  for (const AreaSampling& other :
       {AreaSampling{.first = 512}, AreaSampling{.most = 1024}, AreaSampling{.error = 1e-3},
        AreaSampling{.pattern = 16}, AreaSampling{.integrated = true}})
    EXPECT_NE(truthKey("s", 8, 8, other), key);
}

}  // namespace
}  // namespace sb::test
