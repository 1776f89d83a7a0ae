// The truth of small scenes with media against closed forms (spec 14, invariants 1, 4, 5, 7, 8;
// spec 16, camera path).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "suites/harness/scene_hash.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/scenes/procedural/procedural.h"
#include "tests/truth/traced.h"

namespace sb::test {
namespace {

using glm::dvec3;

constexpr double kIsotropic = 0.25 / std::numbers::pi;

Medium mist(dvec3 low, dvec3 high, glm::vec3 extinction, glm::vec3 albedo = glm::vec3(1)) {
  Medium medium{.name = "mist", .extinction = extinction, .albedo = albedo};
  for (int axis = 0; axis < 3; ++axis) medium.boxToWorld[axis] *= high[axis] - low[axis];
  medium.boxToWorld[3] = glm::dvec4(low, 1);
  return medium;
}

Material glowing(glm::vec3 colour, float alpha = 1) {
  Material m = glass(alpha, glm::vec3(0));
  m.baseColor = glm::vec4(colour, 1);
  m.unlit = true;
  return m;
}

const glm::vec3 kSigma(0.5f, 1, 2), kFloor(0.2f, 0.4f, 0.8f);

/// A glowing floor [-4,4]^2 under a mist [-2,2] x [0,1.5] x [-2,2], seen from above; the sun comes
/// from +x, through the mist alone. Pixel x is world x from -4 to 4.
Scene mistScene() {
  Scene scene;
  addHorizontal(scene, add(scene, glowing(kFloor)), {0, 0, 0}, 4, 4);
  scene.cameras.push_back(downCamera({0, 3, 0}, 4, 8));
  addLight(scene, sun({-1, 0, 0}));
  scene.lights[0].intensity = 2;
  scene.media.push_back(mist({-2, 0, -2}, {2, 1.5, 2}, kSigma, {1, 0.5f, 0.25f}));
  return scene;
}

/// World x of a pixel's centre of a picture 64 wide.
double xOf(uint32_t pixel) { return (pixel + 0.5) / 8 - 4; }

/// What a way of `length` through that mist scatters up, `aside` from where the sun enters it.
dvec3 scattered(double length, double aside) {
  const dvec3 sigma(kSigma);
  return dvec3(1, 0.5, 0.25) * kIsotropic * 2.0 * glm::exp(-sigma * aside) *
         (1.0 - glm::exp(-sigma * length));
}

dvec3 pixelOf(const Truth& t, uint32_t x, uint32_t y) {
  const float* p = t.image.data() + 4 * (size_t(y) * t.width + x);
  return {p[0], p[1], p[2]};
}

TEST(TruthMedia, ABoxOfMistIsItsClosedForm) {
  const Truth t = traced(mistScene());
  const dvec3 passes = glm::exp(-1.5 * dvec3(kSigma));
  for (const uint32_t x : {17u, 32u, 46u})
    expectNear(pixelOf(t, x, 32), scattered(1.5, 2 - xOf(x)) + passes * dvec3(kFloor), 1e-6,
               "within");
  expectNear(pixelOf(t, 10, 32), dvec3(kFloor), 0, "beside");
}

TEST(TruthMedia, WhatStandsInAMediumEndsIt) {
  Scene scene = mistScene();
  addHorizontal(scene, add(scene, glowing({1, 0.5f, 0.25f})), {0, 0.625f, 0}, 0.5f, 0.5f);
  const dvec3 sigma(kSigma);
  expectNear(pixelOf(traced(scene), 32, 32),
             scattered(0.875, 2 - xOf(32)) + glm::exp(-0.875 * sigma) * dvec3(1, 0.5, 0.25), 1e-6,
             "opaque");
  // A pane between: mist before it and mist behind.
  scene.materials[1] = glowing({1, 0.5f, 0.25f}, 0.25f);
  const double aside = 2 - xOf(32);
  const dvec3 behind = scattered(0.625, aside) + glm::exp(-0.625 * sigma) * dvec3(kFloor);
  expectNear(pixelOf(traced(scene), 32, 32),
             scattered(0.875, aside) +
                 glm::exp(-0.875 * sigma) * (0.25 * dvec3(1, 0.5, 0.25) + 0.75 * behind),
             1e-6, "pane");
}

TEST(TruthMedia, RaysThatMeetNothingPassMediaToo) {
  Scene scene = mistScene();
  scene.instances.clear();
  scene.background = {1, 2, 3};
  // Beyond the far plane as well, which cuts surfaces alone; and before the near plane.
  for (const auto& [near, far] : {std::pair(1.0 / 64, 8.0), std::pair(1.0 / 64, 1.0), {6.0, 8.0}}) {
    scene.cameras[0].nearPlane = near;
    scene.cameras[0].farPlane = far;
    expectNear(pixelOf(traced(scene), 32, 32),
               scattered(1.5, 2 - xOf(32)) + glm::exp(-1.5 * dvec3(kSigma)) * dvec3(1, 2, 3), 1e-6,
               "background");
  }
}

TEST(TruthMedia, TheEyeMayStandInAMedium) {
  Scene scene = mistScene();
  for (const double height : {1.5 + 1e-6, 1.5, 1.5 - 1e-6, 0.5}) {
    scene.cameras[0] = downCamera({0, height, 0}, 4, 8);
    const double length = std::min(1.5, height);
    expectNear(pixelOf(traced(scene), 32, 32),
               scattered(length, 2 - xOf(32)) + glm::exp(-length * dvec3(kSigma)) * dvec3(kFloor),
               1e-5, "inside");
  }
}

TEST(TruthMedia, ItsShadowOnTheFloorIsBeersLaw) {
  Scene scene = floorScene(false);
  addLight(scene, sun({0, -1, 0}));
  addLight(scene, sun({1, -1, 0}));
  addLight(scene, pointLight({0, 3, 0}));
  scene.media.push_back(mist({-2, 0.25, -2}, {2, 1.75, 2}, kSigma));
  const Tracer tracer(scene, 64, 64);
  const dvec3 sigma(kSigma);
  const auto at = [&](uint32_t light, uint32_t x) {
    return tracer.visibility(light, *tracer.pointAt(x, 32, 0));
  };
  expectNear(at(0, 32), glm::exp(-1.5 * sigma), 1e-12, "from above");
  expectNear(at(0, 2), dvec3(1), 0, "beside");
  expectNear(at(1, 32), glm::exp(-1.5 * std::sqrt(2.0) * sigma), 1e-12, "aslant");
  // From (3 / 16, 0, -1 / 16) the way to the lamp is 1.5 / 3 of the whole.
  const dvec3 p = tracer.pointAt(33, 32, 0)->position + scene.camera().eye();
  expectNear(at(2, 33), glm::exp(-0.5 * glm::length(dvec3(0, 3, 0) - p) * sigma), 1e-12, "lamp");
}

TEST(TruthMedia, NoDensityIsNoMedium) {
  Scene scene = makeScene("fog");
  Scene none = scene;
  none.media.clear();
  const Truth expected = traced(none, 24);
  EXPECT_TRUE(expected.mediaVisibility.empty());
  const auto expectSame = [&](const Scene& thin) {
    const Truth found = traced(thin, 24);
    EXPECT_EQ(found.image, expected.image);
    EXPECT_EQ(found.visibility, expected.visibility);
    EXPECT_TRUE(found.mediaVisibility.empty());
  };
  scene.media[0].extinction = glm::vec3(0);
  expectSame(scene);
  scene = makeScene("fog:medium=grid");
  std::ranges::fill(scene.media[0].density, 0.0f);
  expectSame(scene);
}

TEST(TruthMedia, VisibilityWithinMediaIsALayerOfItsOwn) {
  Scene scene = mistScene();
  // Hides the sun from what lies behind x = -1.05 and above y = 0.5.
  addQuad(scene, add(scene, matte()), {-1.05f, 1.5f, 0}, {0, 1, 0}, {0, 0, 4});
  const Truth t = traced(scene);
  ASSERT_EQ(t.mediaVisibility.size(), 1u);
  ASSERT_EQ(t.mediaEdges.size(), 1u);
  const auto at = [&](uint32_t x) {
    const float* v = t.mediaVisibility[0].data() + 4 * (32 * 64 + x);
    return glm::dvec4(v[0], v[1], v[2], v[3]);
  };
  // Half way from 1.5 to 0 it is 0.75 high.
  expectNear(dvec3(at(40)), glm::exp(-(2 - xOf(40)) * dvec3(kSigma)), 1e-6, "lit");
  EXPECT_EQ(at(40).w, 1);
  EXPECT_EQ(at(18), glm::dvec4(0, 0, 0, 1)) << "shadowed";
  EXPECT_EQ(at(4), glm::dvec4(0)) << "no medium";
  EXPECT_EQ(t.mediaEdges[0][32 * 64 + 23], 1);
  EXPECT_EQ(t.mediaEdges[0][32 * 64 + 30], 0);
}

TEST(TruthMedia, AnisotropyTurnsLightStraightOn) {
  // The eye looks down; the sun comes from below, from beside and from above.
  for (const float g : {-0.5f, 0.7f})
    for (const auto& [travels, cosine] :
         {std::pair(dvec3(0, 1, 0), 1.0), {dvec3(-1, 0, 0), 0.0}, {dvec3(0, -1, 0), -1.0}}) {
      Scene scene = mistScene();
      scene.instances.clear();
      scene.media[0] = mist({-2, 0, -2}, {2, 1.5, 2}, glm::vec3(1e-3f));
      scene.media[0].anisotropy = g;
      scene.lights[0].direction = travels;
      const double phase = (1 - g * g) / std::pow(1 + g * g - 2 * double(g) * cosine, 1.5);
      EXPECT_NEAR(pixelOf(traced(scene, 8), 4, 4).x / (2 * kIsotropic * 1.5e-3), phase,
                  0.01 * phase)
          << g << " " << cosine;
    }
}

TEST(TruthMedia, DoesNotDependOnThreads) {
  const Scene scene = makeScene("fog:medium=smoke,extinction=4");
  const Truth one = traced(scene, 20, 1), two = traced(scene, 20, 2);
  EXPECT_EQ(one.image, two.image);
  EXPECT_EQ(one.visibility, two.visibility);
  EXPECT_EQ(one.mediaVisibility, two.mediaVisibility);
  EXPECT_EQ(one.mediaEdges, two.mediaEdges);
  EXPECT_EQ(one.rays, two.rays);
}

TEST(TruthMedia, EveryPropertyOfAMediumIsPartOfTheScenesHash) {
  const Scene scene = makeScene("fog:medium=grid");
  const auto differs = [&](const auto& change) {
    Scene other = scene;
    change(other.media[0]);
    EXPECT_NE(sceneHash(other), sceneHash(scene));
  };
  differs([](Medium& m) { m.density[7] += 1; });
  differs([](Medium& m) { std::swap(m.size.x, m.size.y), m.size.x *= 2; });
  differs([](Medium& m) { m.time = 1; });
}

}  // namespace
}  // namespace sb::test
