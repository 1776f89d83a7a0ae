// Stencil shadow volumes (spec 07): exact to the pixel for any caster, any light and any eye; the
// same picture however they are built and counted; what settings break by construction.
#include "suites/scenes/procedural/procedural.h"
#include "suites/scenes/procedural/scenes.h"
#include "suites/scenes/procedural/shapes.h"
#include "tests/techniques/shadow_volume_truth.h"

using namespace sb;
using namespace sb::test;

namespace {

using Setting = std::map<std::string, std::string>;

CellOptions volumes(Setting knobs = {}, rhi::Extent2D size = {96, 64}) {
  return {.technique = "StencilShadowVolume", .knobs = std::move(knobs), .size = size};
}

/// A closed box, a sphere, sheets and a box without a lid over a floor.
Scene stage(bool localLights) {
  Scene scene;
  const uint32_t grey = add(scene, matte()), red = add(scene, matte({0.75f, 0.25f, 0.125f}));
  Material thin = matte({0.25f, 0.5f, 0.75f});
  thin.doubleSided = true;
  const uint32_t sheet = add(scene, thin);
  addHorizontal(scene, grey, {0, 0, 0}, 4, 4);
  addBox(scene, red, {-1.5f, 0, -1}, {-0.5f, 1.25f, 0});
  place(scene, add(scene, sphereMesh("ball", red, 8)),
        translation({0.75, 0.5, 0.75}) * glm::dmat4(glm::dmat3(0.5)));
  addQuad(scene, sheet, {0.5f, 1.5f, -0.5f}, {0.75f, 0.25f, 0}, {0, 0.25f, 0.5f});
  addQuad(scene, grey, {-0.75f, 1.75f, 1.25f}, {0.5f, 0, 0.25f}, {0, 0.25f, 0.75f});
  addLight(scene, sun({0.375, -1, -0.25}));
  if (localLights) {
    addLight(scene, pointLight({1.5, 2.25, 0.5}, 4));
    addLight(scene, spotLight({-1.5, 3, 1.5}, {0.5, -1, -0.5}, 0.75, 6));
  }
  scene.cameras.push_back(lookAt({2.5, 3, 4}, {0, 0.25, 0}));
  return scene;
}

/// The eye in the shadow of a box, the near rectangle across its boundary.
Scene eyeInShadow() {
  Scene scene = stage(true);
  addBox(scene, 1, {-2.5f, 2.5f, -2.5f}, {-1.5f, 3, -1.5f});
  scene.cameras[0] = lookAt({-1.4, 0.6, -1.6}, {0.5, 0.3, 1});
  scene.cameras[0].nearPlane = 0.3;
  return scene;
}

/// Every material opaque.
Scene opaque(Scene scene) {
  for (Material& material : scene.materials) {
    material.alphaMode = AlphaMode::Opaque;
    material.opticsOverride = false;
    material.transmission = 0;
  }
  return scene;
}

const std::vector<Setting> kBuilds = {
    {{"build", "cpu"}}, {{"build", "vertex"}}, {{"build", "geometry"}}, {{"build", "compute"}}};

}  // namespace

GPU_TEST(ShadowVolumes, AreExactForEveryLight) {
  for (const Setting& setting : std::vector<Setting>{
           {}, {{"count", "zfail"}}, {{"casts", "all"}}, {{"sides", "one"}}, {{"counter", "float"}}}) {
    Cell cell(cellDevice(device()), stage(true), volumes(setting));
    expectExact(cell, setting.empty() ? "auto" : setting.begin()->second, 300);
  }
}

GPU_TEST(ShadowVolumes, AreExactWhereverTheEyeIs) {
  for (const Setting& setting :
       std::vector<Setting>{{}, {{"count", "zfail"}}, {{"counter", "float"}}}) {
    Cell cell(cellDevice(device()), eyeInShadow(), volumes(setting));
    expectExact(cell, "in the shadow of a box");
  }
}

GPU_TEST(ShadowVolumes, AreExactForCurvedCasters) {
  Cell cell(cellDevice(device()), opaque(makeScene("teapot")), volumes({}, {128, 96}));
  expectExact(cell, "teapot", 300);
  Cell spheres(cellDevice(device()), opaque(makeScene("spheres_quads")), volumes({}, {128, 96}));
  expectExact(spheres, "spheres", 300);
}

GPU_TEST(ShadowVolumes, EveryBuildDrawsTheSameBits) {
  const auto known = [&](const Scene& scene, Setting knobs) {
    std::vector<std::vector<float>> pictures;
    for (const Setting& build : kBuilds) {
      Setting all = knobs;
      all.insert(build.begin(), build.end());
      Cell cell(cellDevice(device()), scene, volumes(all));
      pictures.push_back(cell.picture().rgba);
      EXPECT_EQ(pictures.back(), pictures.front()) << build.begin()->second;
    }
    return pictures.front();
  };
  for (const Scene& scene : {stage(true), eyeInShadow()}) {
    const std::vector<float> picture = known(scene, {});
    EXPECT_EQ(known(scene, {{"count", "zfail"}}), picture);
    EXPECT_EQ(known(scene, {{"casts", "all"}}), picture);
    EXPECT_EQ(known(scene, {{"sides", "one"}}), picture);
    EXPECT_EQ(known(scene, {{"counter", "float"}}), picture);
  }
}
