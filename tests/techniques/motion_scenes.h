// A camera on its way through a scene in which every step calls for something else: what is in
// view, which lights touch it, who throws shadows, and the order of translucent surfaces.
#pragma once

#include "suites/scenes/edit/camera_path.h"
#include "suites/scenes/procedural/shapes.h"
#include "tests/techniques/cell.h"

namespace sb::test {

/// Coordinates and, without `turn`, all cameras are multiples of 1/64. Panes overlap from the
/// light; `localLights`: a point light between them and a spot light beside.
inline Scene travelled(bool localLights, double turn = 0, uint32_t steps = 5) {
  Scene scene;
  const uint32_t grey = add(scene, matte()), red = add(scene, matte({0.75f, 0.25f, 0.125f}));
  addHorizontal(scene, grey, {0, 0, 0}, 6, 6);
  addBox(scene, red, {-1.5f, 0, -1}, {-0.5f, 1.25f, 0});
  addBox(scene, red, {4, 0, 1}, {5, 2, 2});
  addBox(scene, red, {0.5f, 0.25f, 0.5f}, {1.25f, 0.75f, 1.5f});
  Material masked = matte({0.25f, 0.5f, 0.25f});
  masked.alphaMode = AlphaMode::Mask;
  addBox(scene, add(scene, masked), {-4, 0, 2}, {-3, 1, 3});
  const uint32_t blue = add(scene, glass(0.75f, {0.25f, 0.5f, 1}));
  const uint32_t amber = add(scene, glass(0.5f, {1, 0.5f, 0.25f}));
  addQuad(scene, blue, {0.5f, 1, -0.5f}, {0.75f, 0.25f, 0}, {0, 0.5f, 0.5f});
  addQuad(scene, amber, {-0.25f, 1.5f, 0.75f}, {0.5f, 0, 0.25f}, {0, 0.25f, 0.75f});
  addQuad(scene, blue, {3.5f, 1.25f, 2.5f}, {1, 0, 0}, {0, 0.5f, 0.75f});
  addQuad(scene, amber, {3.25f, 2, 2.25f}, {0.75f, 0.25f, 0}, {0, 0.25f, 1});
  addBox(scene, amber, {-2.5f, 1, 1.5f}, {-1.75f, 1.75f, 2.25f});
  addLight(scene, sun({0.375, -1, -0.25}));
  if (localLights) {
    Light point = pointLight({1.5, 2.25, 0.5}, 4);
    point.range = 4;
    addLight(scene, point);
    Light spot = spotLight({5, 3, 5}, {-0.5, -1, -0.5}, 0.75, 6);
    spot.range = 5;
    addLight(scene, spot);
  }
  scene.cameras.push_back(lookAt({2.5, 3, 4}, {0, 0.25, 0}));
  scene.path = cameraPath(scene.camera(), {-3, 1.5, 3.75}, turn, steps);
  return scene;
}

/// The scene with the camera standing at a step.
inline Scene standingAt(const Scene& scene, uint32_t step) {
  Scene still = scene;
  still.cameras[0] = scene.path[step];
  still.path.clear();
  return still;
}

}  // namespace sb::test
