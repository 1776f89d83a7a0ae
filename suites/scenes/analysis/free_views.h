// What cameras that are set freely show of a scene: of all places at once, for preparing, and of
// the one where the camera stands now.
#pragma once

#include <limits>
#include <memory>

#include "techniques/plan/effects.h"
#include "techniques/scene/scene.h"

namespace sb {

struct SceneTraits;

class FreeViews {
 public:
  /// Of pictures of `aspect` = width / height, and as many `rows` as analyse() has. `scene` must
  /// outlive the views.
  FreeViews(const Scene& scene, double aspect,
            double rows = std::numeric_limits<double>::infinity());
  ~FreeViews();

  /// What any camera, wherever it stands, may show or call for, at every step of the scene's path;
  /// with Effects::overview. A penumbra may be as wide as the picture.
  const Effects& anywhere() const { return m_anywhere; }
  /// What a camera shows while everything stands at a step of the path (0: without one). Takes a
  /// time that grows with instances times lights; nothing that is not in anywhere().
  ViewEffects from(const Camera& camera, uint32_t step = 0) const;

 private:
  const Scene& m_scene;
  double m_aspect, m_rows;
  std::unique_ptr<const SceneTraits> m_traits;
  Effects m_anywhere;
};

}  // namespace sb
