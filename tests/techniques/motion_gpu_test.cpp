// Scenes in motion: every frame of a path is, bit by bit, the frame of a scene that stands there
// with the same plan, for every technique, be it the camera, the world or both that move; and the
// path does not depend on where in the world it lies.
#include "suites/scenes/edit/transform.h"
#include "tests/techniques/gpu_cell.h"
#include "tests/techniques/motion_scenes.h"

using namespace sb;
using namespace sb::test;

namespace {

CellOptions optionsOf(const std::string& technique, std::map<std::string, std::string> knobs = {},
                      const std::string& transparency = "Sorted") {
  if (hasKnob(technique, "size")) knobs.insert({{"size", "96"}, {"kernel", "3"}});
  return {.technique = technique,
          .knobs = std::move(knobs),
          .size = {48, 36},
          .transparency = transparency};
}

/// Two loops of the path against scenes that stand at each step.
void expectFramesOfStandingScenes(rhi::Device& device, const Scene& scene, CellOptions options) {
  std::string name = options.technique + "+" + options.transparency;
  for (const auto& [knob, value] : options.knobs) name += " " + knob + "=" + value;
  Cell moving(cellDevice(device), scene, options);
  options.forced = moving.effects().present;
  const uint32_t steps = uint32_t(scene.path.size());
  for (uint32_t loop = 0; loop < 2; ++loop)
    for (uint32_t k = 0; k < steps; ++k) {
      if (loop + k > 0) moving.renderAgain();
      Cell still(cellDevice(device), standingAt(scene, k), options);
      EXPECT_EQ(moving.picture().rgba, still.picture().rgba)
          << name << ", step " << k << " of loop " << loop;
      if (loop == 0) continue;
      ASSERT_EQ(moving.renderer().lights(), still.renderer().lights()) << name << " " << k;
      for (const uint32_t light : still.renderer().lights())
        EXPECT_EQ(moving.renderer().readVisibility(light), still.visibility(light))
            << name << ", step " << k << ", light " << light;
    }
}

}  // namespace

GPU_TEST(Motion, ShadowTechniquesDrawWhatAStandingCameraSees) {
  for (const ShadowEntry* technique : shadowTechniques()) {
    expectFramesOfStandingScenes(device(), travelled(true), optionsOf(technique->info.name));
    if (!hasKnob(technique->info.name, "fit")) continue;
    expectFramesOfStandingScenes(device(), travelled(false, 60, 4),
                                 optionsOf(technique->info.name, {{"fit", "stable"}}));
  }
}

GPU_TEST(Motion, ShadowTechniquesDrawAWorldThatStands) {
  for (const ShadowEntry* technique : shadowTechniques()) {
    expectFramesOfStandingScenes(device(), inhabited(true), optionsOf(technique->info.name));
    expectFramesOfStandingScenes(device(), restless(), optionsOf(technique->info.name));
    if (!hasKnob(technique->info.name, "fit")) continue;
    expectFramesOfStandingScenes(device(), inhabited(false),
                                 optionsOf(technique->info.name, {{"fit", "stable"}}));
  }
}

GPU_TEST(Motion, WhatTouchesInOneStepAloneStaysExactInAll) {
  for (const ShadowEntry* technique : shadowTechniques())
    expectFramesOfStandingScenes(device(), inhabited(true, true), optionsOf(technique->info.name));
  for (const TransparencyEntry* technique : transparencyTechniques())
    expectFramesOfStandingScenes(device(), inhabited(false, true),
                                 optionsOf("ShadowMap", {}, technique->info.name));
}

GPU_TEST(Motion, OrdersFromTheLightFollowTheWorld) {
  for (const char* order : {"centre", "nearest", "triangle"})
    expectFramesOfStandingScenes(
        device(), inhabited(true),
        optionsOf("TranslucentShadows", {{"variant", "published"}, {"order", order}}));
  for (const char* partition : {"peeled", "batches", "source"})
    expectFramesOfStandingScenes(device(), inhabited(true),
                                 optionsOf("CompositedTranslucent", {{"partition", partition}}));
}

GPU_TEST(Motion, ShadowVolumesFollowTheWorldHoweverTheyAreBuilt) {
  for (const char* build : {"cpu", "vertex", "geometry", "compute"})
    expectFramesOfStandingScenes(device(), restless(),
                                 optionsOf("StencilShadowVolume", {{"build", build}}));
  expectFramesOfStandingScenes(device(), inhabited(true),
                               optionsOf("StencilShadowVolume", {{"counter", "float"}}));
}

GPU_TEST(Motion, PenumbraeFollowTheWorld) {
  expectFramesOfStandingScenes(device(), withSoftLights(restless()), optionsOf("PenumbraWedge"));
}

GPU_TEST(Motion, TransparencyTechniquesDrawAWorldThatStands) {
  for (const TransparencyEntry* technique : transparencyTechniques())
    expectFramesOfStandingScenes(device(), inhabited(false),
                                 optionsOf("ShadowMap", {}, technique->info.name));
  expectFramesOfStandingScenes(device(), inhabited(false),
                               optionsOf("ShadowMap", {{"sort", "triangle"}}));
}

GPU_TEST(Motion, OrdersFromTheLightFollowTheCamera) {
  for (const char* order : {"centre", "nearest", "triangle", "none"})
    expectFramesOfStandingScenes(
        device(), travelled(true),
        optionsOf("TranslucentShadows", {{"variant", "published"}, {"order", order}}));
  for (const char* partition : {"peeled", "batches", "source"})
    expectFramesOfStandingScenes(device(), travelled(true),
                                 optionsOf("CompositedTranslucent", {{"partition", partition}}));
  // Deeper levels than two are peeled on the last.
  expectFramesOfStandingScenes(device(), travelled(true),
                               optionsOf("CompositedTranslucent", {{"levels", "2"}}));
}

GPU_TEST(Motion, TransparencyTechniquesDrawWhatAStandingCameraSees) {
  for (const TransparencyEntry* technique : transparencyTechniques()) {
    // Lists are built in no fixed order; what is sorted out of them is.
    expectFramesOfStandingScenes(device(), travelled(false, -75, 4),
                                 optionsOf("ShadowMap", {}, technique->info.name));
  }
  expectFramesOfStandingScenes(device(), travelled(false, -75, 4),
                               optionsOf("ShadowMap", {{"sort", "triangle"}}));
  expectFramesOfStandingScenes(device(), travelled(false, -75, 4),
                               optionsOf("none", {{"stop", "count"}}, "DepthPeeling"));
}

GPU_TEST(Motion, MeshesChangePlacesAsTheCameraTurns) {
  // Two panes, one before the other along -z and behind it along +x. Moving alone never changes the
  // order of centres along the view direction.
  Scene scene;
  scene.background = {0, 0, 1};
  addQuad(scene, add(scene, glass(0.5f, {1, 0, 0})), {-0.25f, 1, 0}, {1.5f, 0, -1.5f}, {0, 1, 0});
  addQuad(scene, add(scene, glass(0.75f, {0, 1, 0})), {0.25f, 1, 0.125f}, {1.5f, 0, -1.5f},
          {0, 1, 0});
  scene.materials[0].baseColor = {1, 0, 0, 1};
  scene.materials[1].baseColor = {0, 1, 0, 1};
  addLight(scene, sun({0.375, -1, -0.25}));
  scene.cameras.push_back(lookAt({0, 1, 5}, {0, 1, 0}));
  moveCamera(scene, cameraPath(scene.camera().toWorld, {5, 0, 5}, 90, 3));
  expectFramesOfStandingScenes(device(), scene, optionsOf("ShadowMap"));
  for (const char* partition : {"batches", "source"})
    expectFramesOfStandingScenes(device(), scene,
                                 optionsOf("CompositedTranslucent", {{"partition", partition}}));
}

GPU_TEST(Motion, TranslationOfThePathIsBitIdentical) {
  for (const char* technique : {"ShadowMap", "CSSM2", "CompositedTranslucent"})
    for (const glm::dvec3 offset : {glm::dvec3(1e6, -2e6, 3e6), glm::dvec3(1e7)}) {
      Scene moved = travelled(true);
      translateScene(moved, offset);
      Cell here(cellDevice(device()), travelled(true), optionsOf(technique));
      Cell there(cellDevice(device()), moved, optionsOf(technique));
      for (uint32_t k = 0; k < moved.path.size(); ++k) {
        EXPECT_EQ(here.picture().rgba, there.picture().rgba) << technique << ", step " << k;
        here.renderAgain();
        there.renderAgain();
      }
    }
}

GPU_TEST(Motion, ACameraThatStandsAtAStepShowsIt) {
  Cell cell(cellDevice(device()), travelled(true), optionsOf("CSSM2"));
  std::vector<std::vector<float>> pictures = {cell.picture().rgba};
  for (uint32_t k = 1; k < 5; ++k) {
    cell.renderAgain();
    pictures.push_back(cell.picture().rgba);
    EXPECT_NE(pictures[k], pictures[k - 1]) << k;
  }
  for (const uint32_t k : {2u, 0u, 4u, 4u}) {
    cell.standAt(k);
    EXPECT_EQ(cell.picture().rgba, pictures[k]) << k;
    cell.renderAgain();
    EXPECT_EQ(cell.picture().rgba, pictures[k]) << k;
  }
  // Other random numbers at the same place.
  cell.renderer().standStill();
  cell.renderer().setSeed(7);
  cell.renderAgain();
  Cell still(cellDevice(device()), standingAt(travelled(true), 4),
             {.technique = "CSSM2",
              .knobs = {{"size", "96"}, {"kernel", "3"}},
              .size = {48, 36},
              .seed = 7,
              .forced = cell.effects().present});
  EXPECT_EQ(cell.picture().rgba, still.picture().rgba);
  EXPECT_NE(cell.picture().rgba, pictures[4]);
}
