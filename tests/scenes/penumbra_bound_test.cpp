// The bound of penumbrae: exact where it can be worked out, never below what rays show, and what
// follows from it.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "suites/scenes/analysis/analysis.h"
#include "suites/scenes/edit/framing.h"
#include "suites/scenes/procedural/scenes.h"
#include "techniques/plan/plan.h"
#include "techniques/scene/light_area.h"

namespace sb {
namespace {

constexpr double kHeight = 8;  // of the picture, world units

/// A floor at y = 0 below a camera that looks straight down at [-4,4]^2, and a board of half size
/// 0.5 at a height.
Scene board(double y, Light light) {
  Scene scene;
  const uint32_t white = addMaterial(scene, matteMaterial("white", glm::vec3(1)));
  glm::dmat4 lying(1);
  lying[1] = {0, 0, -1, 0}, lying[2] = {0, 1, 0, 0};
  addInstance(scene, "floor", addMesh(scene, quadMesh("floor", white, glm::vec2(4))), lying);
  lying[3].y = y;
  addInstance(scene, "board", addMesh(scene, quadMesh("board", white, glm::vec2(0.5f))), lying);
  scene.lights.push_back(light);
  Camera camera;
  camera.orthographic = true;
  camera.halfHeight = 0.5 * kHeight;
  camera.nearPlane = 0.5, camera.farPlane = 10.5;
  camera.toWorld = lookFrom({0, 10, 0}, {0, 0, 0});
  scene.cameras = {camera};
  return scene;
}

Light softSun(glm::dvec3 direction, double radius) {
  Light light = sunLight(glm::normalize(direction), 0);
  light.angularRadius = radius;
  return light;
}

Light lamp(glm::dvec3 position, double radius) {
  Light light;
  light.type = LightType::Point;
  light.position = position;
  makeSphere(light, radius);
  return light;
}

/// World units.
double boundOf(const Scene& scene) { return analyse(scene, 1).lights[0].penumbra * kHeight; }

TEST(PenumbraBound, OfASunIsExactOnAPlane) {
  EXPECT_EQ(boundOf(board(5, softSun({0, -1, 0}, 0))), 0);
  const double a = 0.02, t = std::atan(0.5);
  EXPECT_NEAR(boundOf(board(5, softSun({0, -1, 0}, a))), 10 * std::tan(a), 1e-4);
  EXPECT_NEAR(boundOf(board(3, softSun({0, -1, 0}, a))), 6 * std::tan(a), 1e-4);
  // The box of the floor reaches 2 units farther along the tilted light than its middle.
  EXPECT_GT(boundOf(board(5, softSun({0.5, -1, 0}, a))), 5 * (std::tan(t + a) - std::tan(t - a)));
  EXPECT_LT(boundOf(board(5, softSun({0.5, -1, 0}, a))),
            1.5 * 5 * (std::tan(t + a) - std::tan(t - a)));
}

TEST(PenumbraBound, NothingAboveNothingSoft) {
  Scene scene = board(5, softSun({0, -1, 0}, 0.02));
  scene.instances.pop_back();
  EXPECT_EQ(boundOf(scene), 0) << "a floor shadows nothing of itself";
}

TEST(PenumbraBound, IsNeverBelowWhatRaysShow) {
  std::mt19937 random(20261128);
  const auto within = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  double closest = 0;
  for (int i = 0; i < 200; ++i) {
    const double y = within(0.5, 5), radius = within(0.02, 0.6);
    const glm::dvec3 middle = {within(-3, 3), within(y + 1, y + 4), within(-3, 3)};
    const double bound = boundOf(board(y, lamp(middle, radius)));
    // A corner of the board, and where rays from the lamp's rim through it meet the floor.
    const glm::dvec3 corner = {within(0, 1) < 0.5 ? -0.5 : 0.5, y, within(0, 1) < 0.5 ? -0.5 : 0.5};
    const LightPatch patch = lightPatch(lamp(middle, radius), middle - corner);
    std::vector<glm::dvec3> hits;
    for (int k = 0; k < 32; ++k) {
      const double turn = 2 * M_PI * k / 32;
      const glm::dvec3 toRim = patch.centre + patch.offset({std::cos(turn), std::sin(turn)});
      if (toRim.y <= 0) continue;
      const glm::dvec3 hit = corner - toRim * (y / toRim.y);
      if (std::abs(hit.x) < 4 && std::abs(hit.z) < 4) hits.push_back(hit);
    }
    for (const glm::dvec3& p : hits)
      for (const glm::dvec3& q : hits) {
        ASSERT_LE(glm::length(p - q), bound * (1 + 1e-9)) << i;
        closest = std::max(closest, glm::length(p - q) / bound);
      }
  }
  EXPECT_GT(closest, 0.5) << "it is a bound, not a guess";
}

TEST(PenumbraBound, RoundReceiversAreBoundedByTheirSize) {
  Scene scene = board(5, softSun({0, -1, 0}, 0.001));
  const double flat = boundOf(scene);
  glm::dmat4 place(0.5);
  place[3] = {2, 1, 2, 1};
  addInstance(scene, "ball", addMesh(scene, sphereMesh("ball", 0, 8)), place);
  EXPECT_GT(boundOf(scene), 10 * flat);
  EXPECT_LT(boundOf(scene), 2) << "no more than the ball's box in the picture";
}

TEST(PenumbraBound, NarrowerThanAPixelIsNotCalledFor) {
  const Scene scene = board(5, softSun({0, -1, 0}, 1e-4));  // 1e-3 units: 0.064 pixels of 512
  const auto runs = [&](double rows) {
    return makePlan(analyse(scene, 1, rows), {Effect::AreaLights}).runs(Effect::AreaLights);
  };
  EXPECT_TRUE(runs(512));
  EXPECT_FALSE(runs(256));
  EXPECT_EQ(analyse(scene, 1, 256).reason[Effect::AreaLights],
            "penumbrae are at most 0.032 pixels wide");
  Scene hard = scene;
  hard.lights[0].angularRadius = 0;
  EXPECT_EQ(analyse(hard, 1, 256).reason[Effect::AreaLights],
            "no light that touches the view has an extent");
}

}  // namespace
}  // namespace sb
