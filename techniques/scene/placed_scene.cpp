#include "techniques/scene/placed_scene.h"

#include <algorithm>
#include <stdexcept>

namespace sb {
namespace {

void put(Camera& camera, const glm::dmat4& toWorld) { camera.toWorld = toWorld; }
void put(Instance& instance, const glm::dmat4& toWorld) { instance.toWorld = toWorld; }
void put(Light& light, const LightPose& pose) {
  light.position = pose.position;
  light.direction = pose.direction;
  light.halfAxes = pose.halfAxes;
}

/// Those of `things` that move, where one step has them.
template <class Thing, class Pose>
void putAll(std::vector<Thing>& things, const std::vector<Pose>& poses) {
  for (Thing& thing : things)
    if (thing.pose != kNone) put(thing, poses.at(thing.pose));
}

template <class Thing, class Pose>
void follow(Scene& scene, Thing& thing, std::vector<Pose> SceneState::*list,
            std::span<const Pose> poses) {
  if (scene.path.empty()) scene.path.resize(poses.size());
  if (scene.path.size() != poses.size())
    throw std::invalid_argument("paths of one scene have different numbers of steps");
  if (thing.pose == kNone) {
    thing.pose = uint32_t((scene.path.front().*list).size());
    for (SceneState& state : scene.path) (state.*list).emplace_back();
  }
  for (size_t k = 0; k < poses.size(); ++k) (scene.path[k].*list)[thing.pose] = poses[k];
  put(thing, poses.back());
}

}  // namespace

PlacedScene::PlacedScene(const Scene& scene, uint32_t step) : m_scene(&scene) {
  if (scene.path.empty()) return;
  m_state = &scene.path.at(step);
  if (scene.camera().pose != kNone) {
    m_camera = scene.camera();
    put(*m_camera, m_state->cameras.at(m_camera->pose));
  }
  m_lights.resize(m_state->lights.size());
  for (const Light& light : scene.lights)
    if (light.pose != kNone) put(m_lights.at(light.pose) = light, m_state->lights[light.pose]);
}

PlacedScene PlacedScene::seenBy(const Camera& camera) const {
  PlacedScene seen = *this;
  seen.m_camera = camera;
  return seen;
}

Moving::Moving(const Scene& scene) {
  if (scene.path.empty()) return;
  camera = scene.camera().pose != kNone;
  lights = std::ranges::any_of(scene.lights, [](const Light& l) { return l.pose != kNone; });
  for (uint32_t i = 0; i < scene.instances.size(); ++i)
    if (scene.instances[i].pose != kNone) instances.push_back(i);
}

void standAt(Scene& scene, uint32_t step) {
  const SceneState& state = scene.path.at(step);
  putAll(scene.cameras, state.cameras);
  putAll(scene.instances, state.instances);
  putAll(scene.lights, state.lights);
}

void moveCamera(Scene& scene, std::span<const glm::dmat4> toWorld) {
  follow(scene, scene.cameras.front(), &SceneState::cameras, toWorld);
}

void moveInstance(Scene& scene, uint32_t instance, std::span<const glm::dmat4> toWorld) {
  follow(scene, scene.instances.at(instance), &SceneState::instances, toWorld);
}

void moveLight(Scene& scene, uint32_t light, std::span<const LightPose> poses) {
  follow(scene, scene.lights.at(light), &SceneState::lights, poses);
}

}  // namespace sb
