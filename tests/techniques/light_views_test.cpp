// Light frusta without a GPU: snapping of a moving view (spec 01, invariant 7 and P9), translation
// by texels, the depth step of spec 01's worked example.
#include "techniques/draw/light_views.h"

#include <gtest/gtest.h>

#include "suites/scenes/analysis/analysis.h"
#include "suites/scenes/edit/transform.h"
#include "suites/scenes/procedural/shapes.h"

namespace sb::test {
namespace {

LightView fitted(const Scene& scene, LightFit fit) {
  const Effects effects = analyse(scene, 1);
  return fitLights(scene, effects, scene.camera(), 1,
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
  const glm::dvec3 p = world - scene.camera().eye() - glm::dvec3(glm::vec3(view.data.origin));
  const glm::dvec4 clip = glm::dmat4(view.data.toClip) * glm::dvec4(p, 1);
  return (glm::dvec2(clip) * 0.5 + 0.5) * 256.0;
}

TEST(LightViews, StableTexelsStandStillUnderAMovingCamera) {
  const Scene scene = wide();
  const LightView before = fitted(scene, LightFit::Stable);
  const glm::dvec2 home = texelOf(scene, before, {1, -1, 2});
  for (int step = 1; step <= 16; ++step) {
    Scene moved = scene;
    moved.cameras[0].toWorld[3] += glm::dvec4(0.37 * step, 0, -0.211 * step, 0);
    const LightView after = fitted(moved, LightFit::Stable);
    EXPECT_EQ(before.data.texel.z, after.data.texel.z);
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
    const glm::dmat4 m(before.data.toClip);
    const glm::dvec3 axis = glm::normalize(glm::dvec3(m[0].x, m[1].x, m[2].x));
    translateScene(moved, axis * (37.0 * before.data.texel.z));
    const LightView after = fitted(moved, fit);
    EXPECT_EQ(before.data.toClip, after.data.toClip);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(before.data.origin[c], after.data.origin[c], 1e-6);
  }
}

TEST(LightViews, DepthStepOfTheWorkedExample) {
  // D24, near 0.1, far 1000: at z = 10 a step of 2^-24 is 5.96e-5 (spec 01).
  const glm::dmat4 m = perspective(1, 1, 0.1, 1000);
  const auto depth = [&](double z) {
    const glm::dvec4 clip = m * glm::dvec4(0, 0, -z, 1);
    return clip.z / clip.w;
  };
  EXPECT_NEAR((depth(10 + 5.96e-5) - depth(10)) * 0x1p24, 1, 1e-3);
  EXPECT_NEAR(depth(0.1), 0, 1e-12);
  EXPECT_NEAR(depth(1000), 1, 1e-12);
}

}  // namespace
}  // namespace sb::test
