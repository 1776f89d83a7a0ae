// Light frusta without a GPU: snapping of a moving view (spec 01, invariant 7 and P9), translation
// by texels, the depth step of spec 01's worked example.
#include "techniques/draw/fit/light_views.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "suites/scenes/analysis/analysis.h"
#include "suites/scenes/edit/transform.h"
#include "suites/scenes/procedural/parts/shapes.h"

namespace sb::test {
namespace {

LightView fitted(const Scene& scene, LightFit fit) {
  const Effects effects = analyse(scene, 1);
  return fitLights(scene, effects, 1,
                   {.mapSize = 256, .guardTexels = 3, .fit = fit, .depthStep = 0x1p-24f})
      .at(0);
}

/// A wide floor, of which the camera sees a part.
Scene wide() {
  Scene scene = floorScene(false);
  addHorizontal(scene, 0, {0, -1, 0}, 400, 400);
  addLight(scene, sun({0.5, -1, 0.25}));
  return scene;
}

/// Where a world point falls in the map, texels.
glm::dvec2 texelOf(const Scene& scene, const LightView& view, const glm::dvec3& world) {
  const glm::dvec3 p = world - scene.camera().eye() - glm::dvec3(view.origin);
  const glm::dvec4 clip = glm::dmat4(view.toClip) * glm::dvec4(p, 1);
  return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * 256.0;
}

TEST(LightViews, StableTexelsStandStillUnderAMovingCamera) {
  const Scene scene = wide();
  const LightView before = fitted(scene, LightFit::Stable);
  const glm::dvec2 home = texelOf(scene, before, {1, -1, 2});
  for (int step = 1; step <= 16; ++step) {
    Scene moved = scene;
    moved.cameras[0].toWorld[3] += glm::dvec4(0.37 * step, 0, -0.211 * step, 0);
    const LightView after = fitted(moved, LightFit::Stable);
    EXPECT_EQ(before.texelWidth, after.texelWidth);
    const glm::dvec2 shift = texelOf(moved, after, {1, -1, 2}) - home;
    EXPECT_NEAR(shift.x, std::round(shift.x), 2e-3) << step;
    EXPECT_NEAR(shift.y, std::round(shift.y), 2e-3) << step;
  }
}

TEST(LightViews, WholeSceneMovedByTexelsKeepsItsProjection) {
  for (const LightFit fit : {LightFit::Tight, LightFit::Stable}) {
    const Scene scene = wide();
    const LightView before = fitted(scene, fit);
    Scene moved = scene;
    // 37 texels along the light's x axis, a row of toClip.
    const glm::dmat4 m(before.toClip);
    const glm::dvec3 axis = glm::normalize(glm::dvec3(m[0].x, m[1].x, m[2].x));
    translateScene(moved, axis * (37.0 * before.texelWidth));
    const LightView after = fitted(moved, fit);
    EXPECT_EQ(before.toClip, after.toClip);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(before.origin[c], after.origin[c], 1e-6);
  }
}

/// A lamp far above a wide floor and a box, of which the camera sees a part.
Scene lamp(const Light& light) {
  Scene scene = floorScene(false);
  addHorizontal(scene, 0, {0, -1, 0}, 900, 900);
  addBox(scene, 0, {-1, 0.1f, -1}, {1, 1, 1});
  scene.cameras[0] = lookAt({2, 6, 7}, {0, 0, 0}, 0.8);
  addLight(scene, light);
  return scene;
}

std::vector<LightView> viewsOf(const Scene& scene, LightFit fit) {
  const Effects effects = analyse(scene, 1);
  return fitLights(scene, effects, 1,
                   {.mapSize = 256, .guardTexels = 3, .fit = fit, .depthStep = 0});
}

TEST(LightViews, LocalFrustaAreFittedToWhatTheCameraSees) {
  const glm::dvec3 place(3, 400, -2);
  for (const Light& light : {spotLight(place, {0, -1, 0}, 1.2, 1e6f), pointLight(place, 1e6f)}) {
    const Scene scene = lamp(light);
    const std::vector<LightView> tight = viewsOf(scene, LightFit::Tight);
    const std::vector<LightView> whole = viewsOf(scene, LightFit::Stable);
    ASSERT_EQ(tight.size(), light.type == LightType::Spot ? 1u : 6u);
    const auto sees = [](const LightView& view) { return view.layer >= 0; };
    ASSERT_EQ(std::ranges::count_if(tight, sees), 1) << "the floor is below alone";
    const LightView& view = *std::ranges::find_if(tight, sees);
    // The picture shows some 15 units: a few texels each instead of a few units a texel.
    EXPECT_LT(view.texelWidth * 400, 0.2);
    EXPECT_GT(whole[size_t(&view - tight.data())].texelWidth * 400, 3.0);
    // Whatever the camera sees lies within the map, its filter included.
    for (int y = -8; y <= 8; ++y)
      for (int x = -8; x <= 8; ++x) {
        Camera camera = scene.camera();
        const double t = std::tan(camera.fovY / 2) / 8;
        const glm::dvec3 ray = glm::dmat3(camera.toWorld) * glm::dvec3(x * t, y * t, -1);
        const glm::dvec3 seen = camera.eye() + ray * ((-1 - camera.eye().y) / ray.y);
        const glm::dvec2 texel = texelOf(scene, view, seen);
        for (int axis = 0; axis < 2; ++axis) {
          EXPECT_GE(texel[axis], 3) << x << " " << y;
          EXPECT_LE(texel[axis], 256 - 3) << x << " " << y;
        }
      }
    EXPECT_EQ(view.opaque.size(), 3u);
  }
}

TEST(LightViews, StableLocalFrustaStandStillUnderAMovingCamera) {
  Scene scene = lamp(spotLight({3, 40, -2}, {0, -1, 0}, 0.9, 1e6f));
  const LightView before = viewsOf(scene, LightFit::Stable)[0];
  scene.cameras[0] = lookAt({4, 3, 7}, {1, 0, 2}, 0.8);
  const LightView after = viewsOf(scene, LightFit::Stable)[0];
  EXPECT_EQ(before.texelWidth, after.texelWidth);
  EXPECT_LT(glm::length(glm::dvec2(before.toClip[0]) - glm::dvec2(after.toClip[0])), 1e-12);
}

TEST(LightViews, DepthStepOfTheWorkedExample) {
  // D24, near 0.1, far 1000: at z = 10 a step of 2^-24 is 5.96e-5 (spec 01), reversed or not.
  const glm::dmat4 m = perspective(1, 1, 0.1, 1000);
  const auto depth = [&](double z) {
    const glm::dvec4 clip = m * glm::dvec4(0, 0, -z, 1);
    return clip.z / clip.w;
  };
  EXPECT_NEAR((depth(10) - depth(10 + 5.96e-5)) * 0x1p24, 1, 1e-3);
  EXPECT_NEAR(depth(0.1), 1, 1e-12);
  EXPECT_NEAR(depth(1000), 0, 1e-12);
}

}  // namespace
}  // namespace sb::test
