// What the tests of shadow volumes draw.
#pragma once

#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/scenes/procedural/scenes.h"
#include "tests/techniques/shadow_volume_truth.h"

namespace sb::test {

using Setting = std::map<std::string, std::string>;

inline CellOptions volumes(Setting knobs = {}, rhi::Extent2D size = {96, 64}) {
  return {.technique = "StencilShadowVolume", .knobs = std::move(knobs), .size = size};
}

/// A closed box, a sphere, sheets and a box without a lid over a floor.
inline Scene stage(bool localLights) {
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
inline Scene eyeInShadow() {
  Scene scene = stage(true);
  addBox(scene, 1, {-2.5f, 2.5f, -2.5f}, {-1.5f, 3, -1.5f});
  scene.cameras[0] = lookAt({-1.4, 0.6, -1.6}, {0.5, 0.3, 1});
  scene.cameras[0].nearPlane = 0.3;
  return scene;
}

}  // namespace sb::test
