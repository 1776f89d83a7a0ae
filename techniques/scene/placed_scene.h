// A scene as it stands at one step of its path: the one way to ask where anything is.
#pragma once

#include <optional>
#include <span>

#include "techniques/scene/scene.h"

namespace sb {

class PlacedScene {
 public:
  /// By itself, which is at the last step. The scene must outlive this object.
  PlacedScene(const Scene& scene) : m_scene(&scene) {}
  /// At a step of its path. A scene without one stands by itself.
  PlacedScene(const Scene& scene, uint32_t step);
  /// The same through another camera.
  PlacedScene seenBy(const Camera& camera) const;

  const Scene& scene() const { return *m_scene; }
  const Camera& camera() const { return m_camera ? *m_camera : m_scene->camera(); }
  const Light& light(uint32_t index) const {
    const Light& own = m_scene->lights[index];
    return m_state && own.pose != kNone ? m_lights[own.pose] : own;
  }
  const glm::dmat4& toWorld(uint32_t instance) const {
    const Instance& own = m_scene->instances[instance];
    return m_state && own.pose != kNone ? m_state->instances[own.pose] : own.toWorld;
  }

 private:
  const Scene* m_scene;
  const SceneState* m_state = nullptr;
  std::optional<Camera> m_camera;  ///< that moves, or is not the scene's
  std::vector<Light> m_lights;     ///< those that move, by pose
};

/// What moves along the path of a scene.
struct Moving {
  explicit Moving(const Scene& scene);
  bool camera = false, lights = false;
  std::vector<uint32_t> instances;  ///< in scene order
};

/// Puts everything that moves where it stands at a step.
void standAt(Scene& scene, uint32_t step);

// What moves, step by step. Scenes that have no path yet get one of so many steps; others must have
// that many. It stands at the last one.
/// The first camera.
void moveCamera(Scene& scene, std::span<const glm::dmat4> toWorld);
void moveInstance(Scene& scene, uint32_t instance, std::span<const glm::dmat4> toWorld);
void moveLight(Scene& scene, uint32_t light, std::span<const LightPose> poses);

}  // namespace sb
