// Scenes in which every step calls for something else: what is in view, which lights touch it, who
// throws shadows, and the order of translucent surfaces. A camera is on its way through them, or
// what they show is.
#pragma once

#include <cmath>

#include "suites/scenes/edit/camera_path.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "techniques/scene/light_area.h"
#include "tests/techniques/cell.h"

namespace sb::test {

/// Coordinates are multiples of 1/64. Panes overlap from the light; `localLights`: a point light
/// between them and a spot light beside.
inline Scene furnished(bool localLights) {
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
  return scene;
}

/// A camera on its way; without `turn`, all its places are multiples of 1/64.
inline Scene travelled(bool localLights, double turn = 0, uint32_t steps = 5) {
  Scene scene = furnished(localLights);
  moveCamera(scene, cameraPath(scene.camera().toWorld, {-3, 1.5, 3.75}, turn, steps));
  return scene;
}

/// An instance's places: shifted by each of `shifts` from where it stands.
inline void shift(Scene& scene, uint32_t instance, std::initializer_list<glm::dvec3> shifts) {
  std::vector<glm::dmat4> places;
  for (const glm::dvec3& by : shifts)
    places.push_back(translation(by) * scene.instances[instance].toWorld);
  moveInstance(scene, instance, places);
}

/// The same things on their own ways, in five steps: they leave the view and come back, cross one
/// another, grow, turn and are mirrored; all lights go round. `touching`: a pane comes to lie on
/// the floor, and the point light passes through a box.
inline Scene inhabited(bool localLights, bool touching = false) {
  Scene scene = furnished(localLights);
  shift(scene, 1, {{0, 0, 0}, {0, 0.5, 0}, {-8, 0, 0}, {0, 0, 0.5}, {0.25, 0, 0}});
  shift(scene, 4, {{-20, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, -1}, {3.5, 0.5, -1.5}});
  shift(scene, 5, {{0, 1, 0}, {0, 0.5, 0.25}, {0, 0, 0}, {0, 0.25, 0}, {-0.5, 0.75, 0.5}});
  shift(scene, 9, {{30, 0, 0}, {30, 0, 0}, {1.5, 0, 0}, {2, 1, 0}, {2, 0, 0}});
  std::vector<glm::dmat4> turns(5, glm::dmat4(1));
  for (uint32_t k = 0; k < 5; ++k) {
    const double c = std::cos(0.4 * k), s = std::sin(0.4 * k);
    turns[k] = translation({0.25 * k, 0, 0}) *
               glm::dmat4(c * 1.25, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0.25, 0, 1);
    if (k == 3) turns[k][1] = -turns[k][1];
    if (k == 3) turns[k][3].y = 1;
  }
  moveInstance(scene, 3, turns);
  if (touching) {
    const uint32_t pane = uint32_t(scene.instances.size());
    addHorizontal(scene, scene.meshes[6].material, {0.5f, 0, 0.75f}, 1, 1);
    shift(scene, pane, {{0, 0.5, 0}, {0, 0, 0}, {0.5, 0, 0}, {0, 0.25, 0}, {-0.5, 0, 0}});
  }
  for (uint32_t l = 0; l < scene.lights.size(); ++l) {
    std::vector<LightPose> poses;
    for (uint32_t k = 0; k < 5; ++k) {
      const Light& own = scene.lights[l];
      const double c = std::cos(0.7 * k), s = std::sin(0.7 * k);
      const auto around = [&](const glm::dvec3& p) {
        return glm::dvec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
      };
      poses.push_back({around(own.position), around(own.direction), own.halfAxes});
      if (touching && own.type == LightType::Point && k == 2) poses[k].position = {4.5, 1, 1.5};
      if (own.type == LightType::Spot && k == 4) poses[k].position = {40, 3, 40};
    }
    moveLight(scene, l, poses);
  }
  return scene;
}

/// Everything moves.
inline Scene restless() {
  Scene scene = inhabited(true);
  moveCamera(scene, cameraPath(scene.camera().toWorld, {-3, 1.5, 3.75}, 20, 5));
  return scene;
}

/// Every light with an extent.
inline Scene withSoftLights(Scene scene) {
  for (Light& light : scene.lights)
    if (light.type == LightType::Directional)
      light.angularRadius = 0.05;
    else
      makeSphere(light, 0.25);
  for (SceneState& step : scene.path)
    for (size_t l = 0; l < step.lights.size(); ++l)
      step.lights[l].halfAxes = scene.lights[l].halfAxes;
  return scene;
}

/// The scene as it stands at a step.
inline Scene standingAt(const Scene& scene, uint32_t step) {
  Scene still = scene;
  standAt(still, step);
  still.path.clear();
  return still;
}

}  // namespace sb::test
