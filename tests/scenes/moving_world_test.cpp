// Scenes in which instances and lights move: where things stand at each step, that loops close, and
// what edits and transforms leave of that.
#include <gtest/gtest.h>

#include <set>

#include "suites/scenes/edit/transform.h"
#include "suites/scenes/edit/world_path.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/scenes/procedural/procedural.h"
#include "techniques/plan/error.h"
#include "techniques/scene/placed_scene.h"

namespace sb {
namespace {

constexpr const char* kSmall = "spheres_quads:quads=20,spheres=30,moving=";

TEST(MovingWorld, SpheresAndQuadsGoRoundCirclesOfTheirOwn) {
  const Scene scene = makeScene(kSmall + std::string("9?motion:steps=5"));
  const Scene still = makeScene("spheres_quads:quads=20,spheres=30");
  ASSERT_EQ(scene.path.size(), 5u);
  const Moving moving(scene);
  EXPECT_FALSE(moving.camera || moving.lights);
  ASSERT_EQ(moving.instances.size(), 9u);
  EXPECT_NE(moving.instances.front(), 0u) << "the floor";
  std::set<uint32_t> meshes;
  for (uint32_t i = 0; i < still.instances.size(); ++i) {
    // The last step is the standing scene's, and a scene that stands.
    EXPECT_EQ(scene.instances[i].toWorld, still.instances[i].toWorld);
    EXPECT_EQ(PlacedScene(scene, 4).toWorld(i), still.instances[i].toWorld);
  }
  for (const uint32_t i : moving.instances) {
    meshes.insert(scene.instances[i].mesh);
    // Five places on a circle: each as far from the next, and the last from the first.
    const auto at = [&](uint32_t k) { return glm::dvec3(PlacedScene(scene, k % 5).toWorld(i)[3]); };
    const double side = glm::length(at(1) - at(0));
    EXPECT_GT(side, 0.2);
    for (uint32_t k = 1; k < 5; ++k) {
      EXPECT_NEAR(glm::length(at(k + 1) - at(k)), side, 1e-12);
      EXPECT_NEAR(glm::determinant(glm::dmat3(PlacedScene(scene, k).toWorld(i))),
                  glm::determinant(glm::dmat3(scene.instances[i].toWorld)), 1e-12);
    }
  }
  EXPECT_EQ(meshes.size(), 2u) << "spheres and quads";
}

TEST(MovingWorld, SeedsAndCountsSayWhatMoves) {
  const auto moved = [](const std::string& spec) { return Moving(makeScene(spec)).instances; };
  EXPECT_EQ(moved(kSmall + std::string("9")), moved(kSmall + std::string("9")));
  EXPECT_NE(moved(kSmall + std::string("9")), moved(kSmall + std::string("9,seed=2")));
  EXPECT_EQ(moved(kSmall + std::string("22000")).size(), 50u) << "all there are";
  EXPECT_TRUE(makeScene(kSmall + std::string("0")).path.empty());
  EXPECT_EQ(makeScene(kSmall + std::string("1")).path.size(), 8u);
}

TEST(MovingWorld, LightsCircleAboutTheVertical) {
  for (const char* name :
       {"layers", "panes", "penumbra", "spheres_quads", "teapot", "window", "fog"}) {
    const Scene scene = makeScene(std::string(name) + ":circling=360?motion:steps=4");
    const Scene still = makeScene(name);
    ASSERT_EQ(scene.path.size(), 4u) << name;
    EXPECT_TRUE(Moving(scene).lights) << name;
    for (uint32_t l = 0; l < still.lights.size(); ++l) {
      EXPECT_EQ(scene.lights[l].direction, still.lights[l].direction) << name;
      // Two steps are half a turn.
      const glm::dvec3 a = PlacedScene(scene, 1).light(l).direction, b = still.lights[l].direction;
      EXPECT_NEAR(glm::length(a - glm::dvec3(-b.x, b.y, -b.z)), 0, 1e-12) << name;
    }
  }
  const Scene lamp = makeScene("teapot:light=rectangle,circling=90?motion:steps=3");
  const auto at = [&](uint32_t k) { return PlacedScene(lamp, k).light(0); };
  EXPECT_NEAR(at(0).position.y, at(2).position.y, 1e-12);
  EXPECT_NEAR(glm::dot(at(0).halfAxes[0], at(0).direction), 0, 1e-12) << "it faces as it did";
  EXPECT_GT(glm::length(at(0).position - at(1).position), 5);
  EXPECT_EQ(at(2).halfAxes, lamp.lights[0].halfAxes);
  // Counterclockwise as seen from above: from +x to -z.
  Light light;
  light.position = {0, 2, -1};
  const std::vector<LightPose> quarter = lightCircle(light, {0, 7, 0}, 180, 2);
  EXPECT_NEAR(glm::length(quarter[0].position - glm::dvec3(1, 2, 0)), 0, 1e-12);
  EXPECT_EQ(quarter[1].position, light.position);
}

TEST(MovingWorld, EditsAndMotionGoTogether) {
  // Another sun circles as the old one would; the camera goes its own way in as many steps.
  const Scene scene =
      makeScene("layers:circling=180?sun:direction=1,-1,0;motion:move=0,1,0,steps=3;ground:size=3");
  ASSERT_EQ(scene.path.size(), 3u);
  EXPECT_NEAR(PlacedScene(scene, 1).light(0).direction.x, 0.5 * std::sqrt(0.5), 1e-12);
  EXPECT_NE(PlacedScene(scene, 0).camera().eye(), scene.camera().eye());
  EXPECT_TRUE(Moving(scene).instances.empty());
  for (const char* spec :
       {"layers?motion:steps=4", "layers?motion:turn=0", "layers:circling=90?motion:move=0,0,0"})
    EXPECT_THROW(makeScene(spec), InputError) << spec;
  EXPECT_EQ(canonicalSceneSpec("teapot:circling=90?motion:steps=4"),
            "teapot:circling=90?motion:steps=4");
}

TEST(MovingWorld, TransformsReachEveryStep) {
  Scene scene = makeScene(kSmall + std::string("4,circling=90?motion:move=1,2,3,steps=3"));
  const Scene before = scene;
  translateScene(scene, {1, 2, 3});
  scaleScene(scene, 2);
  for (uint32_t k = 0; k < 3; ++k) {
    const PlacedScene a(before, k), b(scene, k);
    EXPECT_EQ(b.camera().eye(), 2.0 * (a.camera().eye() + glm::dvec3(1, 2, 3)));
    EXPECT_EQ(b.camera().toWorld[0], a.camera().toWorld[0]);
    EXPECT_EQ(b.light(0).direction, a.light(0).direction);
    for (uint32_t i = 0; i < scene.instances.size(); ++i) {
      EXPECT_EQ(glm::dvec3(b.toWorld(i)[3]),
                2.0 * (glm::dvec3(a.toWorld(i)[3]) + glm::dvec3(1, 2, 3)));
      EXPECT_EQ(b.toWorld(i)[0], 2.0 * a.toWorld(i)[0]);
    }
  }
  permuteScene(scene, 5);
  for (uint32_t i = 0; i < scene.instances.size(); ++i)
    EXPECT_EQ(PlacedScene(scene, 2).toWorld(i), scene.instances[i].toWorld);
}

TEST(MovingWorld, PathsOfOneSceneHaveTheSameSteps) {
  Scene scene = makeScene("layers");
  moveCamera(scene, std::vector<glm::dmat4>(3, glm::dmat4(1)));
  EXPECT_THROW(moveInstance(scene, 0, std::vector<glm::dmat4>(4, glm::dmat4(1))),
               std::invalid_argument);
  moveInstance(scene, 1,
               std::vector{translation({1, 0, 0}), translation({2, 0, 0}), glm::dmat4(1)});
  standAt(scene, 1);
  EXPECT_EQ(scene.instances[1].toWorld, translation({2, 0, 0}));
  EXPECT_EQ(scene.instances[0].pose, kNone);
}

}  // namespace
}  // namespace sb
