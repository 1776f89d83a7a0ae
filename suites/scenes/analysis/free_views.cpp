#include "suites/scenes/analysis/free_views.h"

#include <algorithm>
#include <cmath>

#include "suites/scenes/analysis/parts.h"
#include "suites/scenes/edit/framing.h"
#include "techniques/plan/scene_order.h"
#include "techniques/scene/box.h"

namespace sb {
namespace {

/// Sees all instances and media at every step of the path.
Camera overviewOf(const Scene& scene, double aspect) {
  Box all = sceneBox(scene);
  for (uint32_t k = 0; k < scene.path.size(); ++k) {
    const PlacedScene placed(scene, k);
    for (uint32_t i = 0; i < scene.instances.size(); ++i)
      all.add(instanceBox(placed, i, glm::dvec3(0)));
  }
  Camera camera;
  if (all.empty()) return camera;
  camera.fovY = 0.8;
  // The narrower half angle of the picture holds the sphere around everything.
  const double half = std::atan(std::tan(0.5 * camera.fovY) * std::min(1.0, aspect));
  const double radius = std::max(all.radius(), 1e-3);
  const double distance = 1.1 * radius / std::sin(half);
  const glm::dvec3 from = glm::normalize(glm::dvec3(0.4, 0.7, 1));
  camera.toWorld = lookFrom(all.center() + distance * from, all.center());
  camera.nearPlane = 0.5 * (distance - radius);
  camera.farPlane = 2 * (distance + radius);
  return camera;
}

/// Both are conservative, each with its own rounding: what one leaves out, no pixel shows.
void keepView(ViewEffects& view, const ViewEffects& all) {
  keepCommon(view.visibleOpaque, all.visibleOpaque);
  keepCommon(view.visibleTranslucent, all.visibleTranslucent);
  keepCommon(view.visibleMedia, all.visibleMedia);
  for (size_t i = 0; i < view.lights.size(); ++i) {
    LightEffects& light = view.lights[i];
    light.touchesView &= all.lights[i].touchesView;
    keepCommon(light.opaqueCasters, all.lights[i].opaqueCasters);
    keepCommon(light.perforatedCasters, all.lights[i].perforatedCasters);
    keepCommon(light.translucentCasters, all.lights[i].translucentCasters);
    keepCommon(light.media, all.lights[i].media);
  }
}

}  // namespace

FreeViews::FreeViews(const Scene& scene, double aspect, double rows)
    : m_scene(scene),
      m_aspect(aspect),
      m_rows(rows),
      m_traits(std::make_unique<const SceneTraits>(scene)) {
  const Analysis::Shape shape = {aspect, rows, true};
  if (scene.path.empty()) {
    m_anywhere = analyseView(Analysis(scene, *m_traits, shape));
  } else {
    std::vector<Effects> steps;
    for (uint32_t k = 0; k < scene.path.size(); ++k)
      steps.push_back(analyseView(Analysis(PlacedScene(scene, k), *m_traits, shape)));
    m_anywhere = uniteSteps(std::move(steps));
  }
  m_anywhere.overview = overviewOf(scene, aspect);
}

FreeViews::~FreeViews() = default;

ViewEffects FreeViews::from(const Camera& camera, uint32_t step) const {
  const PlacedScene placed = PlacedScene(m_scene, step).seenBy(camera);
  ViewEffects view = viewEffects(Analysis(placed, *m_traits, {m_aspect, m_rows}));
  keepView(view, m_anywhere.steps.empty() ? m_anywhere : m_anywhere.steps.at(step));
  return view;
}

}  // namespace sb
