// Changes that a scene's spec carries: camera, sun, materials by glob; wrong ones are named.
#include "suites/scenes/edit/scene_edit.h"

#include <gtest/gtest.h>

#include "suites/scenes/edit/framing.h"
#include "suites/scenes/procedural/procedural.h"
#include "techniques/plan/error.h"
#include "techniques/scene/placed_scene.h"

namespace sb {
namespace {

std::string messageOf(const std::string& spec) {
  try {
    makeScene(spec);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(SceneEdit, CanonicalTextIsEqualForEqualEdits) {
  EXPECT_EQ(canonicalSceneSpec("layers?x*:t=.5,alpha=0.50"),
            "layers?x*:alpha=0.5,t=0.5,0.5,0.5");
  EXPECT_EQ(canonicalSceneSpec("a b.gltf?camera:at=0,0,0,eye=1,2,-0;sun:direction=0,-1,0"),
            "a b.gltf?camera:eye=1,2,0,at=0,0,0;sun:direction=0,-1,0");
  EXPECT_EQ(canonicalSceneSpec("layers"), "layers");
}

TEST(SceneEdit, CameraLooksFromEyeAtTarget) {
  const Scene scene = makeScene("layers?camera:eye=1,2,3,at=1,2,-7,fov=90");
  EXPECT_EQ(scene.camera().eye(), glm::dvec3(1, 2, 3));
  EXPECT_NEAR(glm::length(glm::dvec3(scene.camera().toWorld[2]) - glm::dvec3(0, 0, 1)), 0, 1e-12);
  EXPECT_NEAR(scene.camera().fovY, 1.5707963, 1e-6);
  EXPECT_LT(scene.camera().nearPlane, scene.camera().farPlane);
}

TEST(SceneEdit, SunReplacesAllLights) {
  const Scene scene = makeScene("layers?sun:direction=0,-2,0,lux=5");
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].type, LightType::Directional);
  EXPECT_EQ(scene.lights[0].direction, glm::dvec3(0, -1, 0));
  EXPECT_EQ(scene.lights[0].intensity, 5);
}

TEST(SceneEdit, WhatWasAddedForWantOfCameraAndLightIsSaidOnlyWhenItStays) {
  Scene scene = makeScene("layers");
  scene.warnings = {kCameraAdded, kLightAdded, "kept"};
  applyEdits(scene, parseEdits("camera:eye=1,2,3,at=0,0,0"));
  EXPECT_EQ(scene.warnings, (std::vector<std::string>{kLightAdded, "kept"}));
  applyEdits(scene, parseEdits("sun:direction=0,-1,0"));
  EXPECT_EQ(scene.warnings, (std::vector<std::string>{"kept"}));
}

TEST(SceneEdit, MotionArrivesWhereTheCameraStands) {
  // Wherever it stands in the list.
  const Scene scene = makeScene(
      "layers?motion:move=1,-2,3,turn=90,steps=3;camera:eye=4,5,6,at=4,5,0");
  const Scene still = makeScene("layers?camera:eye=4,5,6,at=4,5,0");
  ASSERT_EQ(scene.path.size(), 3u);
  EXPECT_EQ(scene.camera().toWorld, still.camera().toWorld);
  const auto cameraAt = [&](uint32_t k) { return PlacedScene(scene, k).camera(); };
  EXPECT_EQ(cameraAt(2).toWorld, scene.camera().toWorld);
  EXPECT_EQ(cameraAt(1).eye(), glm::dvec3(3.5, 6, 4.5));
  EXPECT_EQ(cameraAt(0).eye(), glm::dvec3(3, 7, 3));
  // Looks along -z in the end, and a quarter turn clockwise of that, along +x, at first.
  EXPECT_NEAR(glm::length(glm::dvec3(cameraAt(0).toWorld[2]) - glm::dvec3(-1, 0, 0)), 0, 1e-12);
  for (uint32_t k = 0; k < 3; ++k) {
    const Camera camera = cameraAt(k);
    EXPECT_EQ(camera.toWorld[1], scene.camera().toWorld[1]);
    EXPECT_NEAR(glm::dot(glm::cross(glm::dvec3(camera.toWorld[0]), glm::dvec3(camera.toWorld[1])),
                         glm::dvec3(camera.toWorld[2])), 1, 1e-12);
    EXPECT_EQ(camera.farPlane, scene.camera().farPlane);
  }
  EXPECT_EQ(makeScene("layers?motion:move=1,0,0").path.size(), 8u);
  EXPECT_EQ(canonicalSceneSpec("layers?motion:steps=4,move=1,0,0"),
            "layers?motion:move=1,0,0,steps=4");
}

TEST(SceneEdit, MaterialsByGlob) {
  const Scene before = makeScene("teapot");
  const Scene after = makeScene("teapot?*:alpha=0.25,t=0.5,0.75,1");
  ASSERT_EQ(before.materials.size(), after.materials.size());
  for (const Material& m : after.materials) {
    EXPECT_TRUE(m.opticsOverride);
    EXPECT_EQ(m.overrideAlpha, 0.25f);
    EXPECT_EQ(m.overrideTransmission, glm::vec3(0.5f, 0.75f, 1));
  }
}

TEST(SceneEdit, WrongOnesAreNamed) {
  const std::pair<const char*, const char*> cases[] = {
      {"layers?", "expected GLOB"},
      {"layers?nothing:alpha=1", "unknown material 'nothing'"},
      {"layers?*:alpha=2", "alpha holds '2', expected a number from 0 to 1"},
      {"layers?*:t=1", "lacks alpha"},
      {"layers?*:alpha=1,t=1,1", "t has 2 numbers, expected 3"},
      {"layers?*:alpha=1,alpha=1", "alpha is given twice"},
      {"layers?*:alpha=x", "alpha holds 'x'"},
      {"layers?*:opacity=1", "unknown key 'opacity'"},
      {"layers?camera:eye=1,2,3", "lacks at"},
      {"layers?camera:eye=1,2,3,at=1,2,3", "the same point"},
      {"layers?motion:steps=3", "lacks move or turn: nothing else in the scene moves"},
      {"layers?motion:turn=0", "neither moves nor turns"},
      {"layers?motion:move=0,0,0", "neither moves nor turns"},
      {"layers?motion:move=1,0,0,steps=1", "steps holds '1', expected a number from 2 to 64"},
      {"layers?motion:move=1,0,0,steps=2.5", "expected a whole number"},
      {"layers?sun:direction=0,0,0", "no length"}};
  for (const auto& [spec, text] : cases)
    EXPECT_NE(messageOf(spec).find(text), std::string::npos) << spec << ": " << messageOf(spec);
}

}  // namespace
}  // namespace sb
