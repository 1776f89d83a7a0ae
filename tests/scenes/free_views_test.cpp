// Effects of a camera that is set freely hold what any camera shows.
#include "suites/scenes/analysis/free_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "suites/scenes/analysis/analysis.h"
#include "suites/scenes/edit/framing.h"
#include "tests/techniques/motion_scenes.h"

using namespace sb;
using namespace sb::test;

namespace {

constexpr double kAspect = 4.0 / 3.0, kRows = 36;

/// Anywhere within and around the scenes, some of them far away.
std::vector<Camera> cameras() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Camera> list = {lookAt({-6, 1, 0.25}, {0, 1, 0})};
  for (int i = 0; i < 60; ++i) {
    const double away = i % 10 == 0 ? 1e5 : 6;
    const glm::dvec3 eye = away * glm::dvec3(unit(random), unit(random), unit(random));
    Camera camera;
    camera.toWorld = lookFrom(eye, glm::dvec3(unit(random), unit(random), unit(random)));
    camera.fovY = 0.2 + 1.2 * (1 + unit(random));
    camera.orthographic = i % 4 == 1;
    camera.nearPlane = i % 3 == 0 ? 1e-3 : 0.1;
    camera.farPlane = 10 * away;
    list.push_back(camera);
  }
  return list;
}

Scene softened(Scene scene) {
  scene.lights.front().angularRadius = 0.02;
  return scene;
}

/// Nothing but planes: two panes side by side over a floor, as the scene's own camera sees them.
Scene flat() {
  Scene scene;
  addHorizontal(scene, add(scene, matte()), {0, 0, 0}, 6, 6);
  const uint32_t pane = add(scene, glass(0.5f, {1, 0.5f, 0.25f}));
  addQuad(scene, pane, {-2, 1, 0}, {0.5f, 0, 0}, {0, 0.5f, 0});
  addQuad(scene, pane, {2, 1, 0}, {0.5f, 0, 0}, {0, 0.5f, 0});
  addLight(scene, sun({0.375, -1, -0.25}));
  scene.cameras.push_back(lookAt({0, 1, 6}, {0, 1, 0}));
  return softened(scene);
}

bool within(const std::vector<uint32_t>& some, const std::vector<uint32_t>& all) {
  return std::ranges::includes(all, some);
}

void expectWithin(const ViewEffects& view, const ViewEffects& all) {
  EXPECT_TRUE(within(view.visibleOpaque, all.visibleOpaque));
  EXPECT_TRUE(within(view.visibleTranslucent, all.visibleTranslucent));
  EXPECT_TRUE(within(view.visibleMedia, all.visibleMedia));
  ASSERT_EQ(view.lights.size(), all.lights.size());
  for (size_t i = 0; i < all.lights.size(); ++i) {
    const LightEffects &light = view.lights[i], &most = all.lights[i];
    EXPECT_LE(light.touchesView, most.touchesView);
    EXPECT_TRUE(within(light.opaqueCasters, most.opaqueCasters));
    EXPECT_TRUE(within(light.perforatedCasters, most.perforatedCasters));
    EXPECT_TRUE(within(light.translucentCasters, most.translucentCasters));
    EXPECT_TRUE(within(light.media, most.media));
    EXPECT_LE(light.penumbra, most.penumbra * (1 + 1e-12));
  }
}

}  // namespace

TEST(FreeViews, AnywhereHoldsWhatAnyCameraShows) {
  for (const Scene& scene : {softened(furnished(true)), furnished(false), flat()}) {
    const FreeViews views(scene, kAspect, kRows);
    for (const Camera& camera : cameras()) {
      Scene seen = scene;
      seen.cameras.front() = camera;
      const Effects alone = analyse(seen, kAspect, kRows);
      EXPECT_TRUE((alone.present - views.anywhere().present).empty());
      // Far away roundings are coarser, and lists longer by what nothing shows.
      if (glm::length(camera.eye()) < 1e3) expectWithin(alone, views.anywhere());
      expectWithin(views.from(camera), views.anywhere());
      expectWithin(views.from(camera), alone);
    }
  }
}

TEST(FreeViews, ACameraShowsWhatItsOwnAnalysisSays) {
  const Scene scene = softened(furnished(true));
  const FreeViews views(scene, kAspect, kRows);
  for (const Camera& camera : cameras()) {
    if (glm::length(camera.eye()) > 1e3) continue;
    Scene seen = scene;
    seen.cameras.front() = camera;
    const Effects alone = analyse(seen, kAspect, kRows);
    expectWithin(alone, views.from(camera));
    for (size_t i = 0; i < scene.lights.size(); ++i)
      EXPECT_EQ(views.from(camera).lights[i].penumbra, alone.lights[i].penumbra);
  }
}

TEST(FreeViews, AFarCameraAddsNothingByItsCoarserRounding) {
  // A sign that no light shines on, beside the floor by less than what is rounded at such a
  // distance.
  Scene scene;
  addHorizontal(scene, add(scene, matte()), {0, 0, 0}, 4, 4);
  Material sign = matte();
  sign.unlit = true;
  const uint32_t beside = addBox(scene, add(scene, sign), {4.0625f, 1, -1}, {5, 2, 1});
  addLight(scene, sun({0, -1, 0}));
  scene.cameras.push_back(lookAt({0, 1, 6}, {0, 1, 0}));
  const FreeViews views(scene, kAspect, kRows);
  Scene seen = scene;
  seen.cameras.front() = lookAt({0, 1e5, 1}, {0, 0, 0}, 1e-3, 1e6);
  ASSERT_TRUE(within({beside}, analyse(seen, kAspect, kRows).lights[0].opaqueCasters));
  EXPECT_FALSE(within({beside}, views.anywhere().lights[0].opaqueCasters));
  EXPECT_FALSE(within({beside}, views.from(seen.cameras.front()).lights[0].opaqueCasters));
}

TEST(FreeViews, StepsOfAWorldAreSeenFromAnywhereToo) {
  const Scene scene = inhabited(true);
  const FreeViews views(scene, kAspect, kRows);
  ASSERT_EQ(views.anywhere().steps.size(), scene.path.size());
  for (uint32_t k = 0; k < scene.path.size(); ++k) {
    expectWithin(views.anywhere().steps[k], views.anywhere());
    for (const Camera& camera : cameras()) {
      Scene still = standingAt(scene, k);
      still.cameras.front() = camera;
      if (glm::length(camera.eye()) < 1e3)
        expectWithin(analyse(still, kAspect, kRows), views.from(camera, k));
      expectWithin(views.from(camera, k), views.anywhere().steps[k]);
    }
  }
}

TEST(FreeViews, TheOverviewSeesEverything) {
  for (const Scene& scene : {furnished(true), inhabited(true)}) {
    const FreeViews views(scene, 0.5);
    ASSERT_TRUE(views.anywhere().overview);
    const uint32_t steps = std::max<uint32_t>(1, uint32_t(scene.path.size()));
    for (uint32_t k = 0; k < steps; ++k) {
      const ViewEffects seen = views.from(*views.anywhere().overview, k);
      EXPECT_EQ(seen.visibleOpaque.size() + seen.visibleTranslucent.size(), scene.instances.size());
      EXPECT_EQ(seen.visibleOpaque, views.anywhere().visibleOpaque);
    }
  }
}
