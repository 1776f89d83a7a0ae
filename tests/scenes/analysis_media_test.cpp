// Which media a scene calls for, for the eye and for each light, and what decides that one is
// skipped (spec 14, "Skip").
#include <gtest/gtest.h>

#include "suites/scenes/analysis/analysis.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "techniques/scene/placed_scene.h"

namespace sb::test {
namespace {

using Indices = std::vector<uint32_t>;

/// A unit cube of mist around a place.
Medium mistAt(glm::dvec3 place) {
  return {.name = "mist",
          .boxToWorld = translation(place - 0.5),
          .extinction = glm::vec3(1),
          .albedo = glm::vec3(1)};
}

/// A floor [-4,4]^2 seen from (0, 0.5, 0), the sun straight above, and mist.
Scene sceneOf(std::vector<Medium> media) {
  Scene scene = floorScene();
  scene.media = std::move(media);
  return scene;
}

bool calledFor(const Effects& e) { return e.present.has(Effect::ParticipatingMedia); }

TEST(AnalysisMedia, WhatTheEyeSeesAndWhatLiesBeforeALight) {
  // In view; above the eye, in the floor's light; beside both.
  Scene scene = sceneOf({mistAt({1, 0, 1}), mistAt({2, 5, 2}), mistAt({20, 5, 0})});
  Effects e = analyse(scene, 1);
  EXPECT_TRUE(calledFor(e));
  EXPECT_EQ(e.reason[Effect::ParticipatingMedia], "1 medium box in view");
  EXPECT_EQ(e.visibleMedia, Indices{0});
  EXPECT_EQ(e.lights[0].media, (Indices{0, 1}));
  scene.media.erase(scene.media.begin());
  e = analyse(scene, 1);
  EXPECT_TRUE(calledFor(e));
  EXPECT_EQ(e.reason[Effect::ParticipatingMedia], "a medium lies between a light and the view");
  EXPECT_TRUE(e.visibleMedia.empty());
  EXPECT_EQ(e.lights[0].media, Indices{0});
  scene.media.erase(scene.media.begin());
  e = analyse(scene, 1);
  EXPECT_FALSE(calledFor(e));
  EXPECT_EQ(e.reason[Effect::ParticipatingMedia],
            "no medium is in view or between a light and the view");
  EXPECT_TRUE(e.lights[0].media.empty());
  scene.media.clear();
  EXPECT_EQ(analyse(scene, 1).reason[Effect::ParticipatingMedia], "the scene has no medium");
}

TEST(AnalysisMedia, LightsHaveTheirOwn) {
  Scene scene = sceneOf({mistAt({-2, 1.5, 0}), mistAt({2, 1.5, 0})});
  scene.lights.clear();
  Light left = pointLight({-2, 3, 0}), right = pointLight({2, 3, 0}), away = pointLight({0, 90, 0});
  left.range = right.range = 3.5, away.range = 2;
  for (const Light& light : {left, right, away}) addLight(scene, light);
  const Effects e = analyse(scene, 1);
  EXPECT_EQ(e.lights[0].media, Indices{0});
  EXPECT_EQ(e.lights[1].media, Indices{1});
  EXPECT_FALSE(e.lights[2].touchesView);
  EXPECT_TRUE(e.lights[2].media.empty());
}

TEST(AnalysisMedia, WhatIsTooThinIsSkipped) {
  Scene scene = sceneOf({mistAt({1, 0, 1})});
  const double longest = std::sqrt(3.0);
  scene.media[0].extinction = {0, float(1.001e-4 / longest), 0};
  EXPECT_TRUE(calledFor(analyse(scene, 1)));
  scene.media[0].extinction = {0, float(0.999e-4 / longest), 0};
  Effects e = analyse(scene, 1);
  EXPECT_FALSE(calledFor(e));
  EXPECT_EQ(e.reason[Effect::ParticipatingMedia], "no medium is dense enough to be seen");
  EXPECT_TRUE(e.visibleMedia.empty());
  EXPECT_TRUE(e.lights[0].media.empty());
  scene.media[0].kind = MediumKind::Grid;
  scene.media[0].size = {1, 1, 2};
  scene.media[0].density = {0, 1.5f};
  EXPECT_TRUE(calledFor(analyse(scene, 1))) << "density 1.5";
  scene.media[0].density = {0, 0};
  EXPECT_FALSE(calledFor(analyse(scene, 1)));
}

TEST(AnalysisMedia, NearAndFarPlanesDoNotCutMedia) {
  Scene scene = sceneOf({mistAt({0, -30, 0})});
  scene.cameras[0].farPlane = 8;
  EXPECT_EQ(analyse(scene, 1).visibleMedia, Indices{0}) << "behind the far plane";
  scene.media = {mistAt({0, 0, 0})};
  scene.cameras[0].nearPlane = 4;
  EXPECT_EQ(analyse(scene, 1).visibleMedia, Indices{0}) << "before the near plane";
  scene.media = {mistAt({0, 3, 0})};
  EXPECT_TRUE(analyse(scene, 1).visibleMedia.empty()) << "behind the eye";
}

TEST(AnalysisMedia, OnlyWhatScattersNeedsLight) {
  Scene scene = sceneOf({mistAt({0, 0, 0})});
  scene.instances.clear();
  EXPECT_TRUE(analyse(scene, 1).lights[0].touchesView);
  scene.media[0].albedo = glm::vec3(0);
  EXPECT_FALSE(analyse(scene, 1).lights[0].touchesView);
  EXPECT_TRUE(calledFor(analyse(scene, 1))) << "it dims the background";
}

TEST(AnalysisMedia, APathCallsForWhatItsStepsSee) {
  Scene scene = sceneOf({mistAt({0, 0, 0}), mistAt({20, 0, 0})});
  glm::dmat4 beside = scene.camera().toWorld;
  beside[3].x = 20;
  moveCamera(scene, std::vector{beside, scene.camera().toWorld});
  const Effects e = analyse(scene, 1);
  EXPECT_EQ(e.visibleMedia, (Indices{0, 1}));
  ASSERT_EQ(e.steps.size(), 2u);
  EXPECT_EQ(e.steps[0].visibleMedia, Indices{1});
  EXPECT_EQ(e.steps[1].visibleMedia, Indices{0});
  EXPECT_EQ(e.lights[0].media, (Indices{0, 1}));
}

}  // namespace
}  // namespace sb::test
