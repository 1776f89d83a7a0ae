// A scene that moves calls for whatever any step of its path calls for.
#include <algorithm>

#include "suites/scenes/analysis/parts.h"
#include "techniques/plan/scene_order.h"

namespace sb {
namespace {

void addView(ViewEffects& to, const ViewEffects& from) {
  addAll(to.visibleOpaque, from.visibleOpaque);
  addAll(to.visibleTranslucent, from.visibleTranslucent);
  addAll(to.visibleMedia, from.visibleMedia);
  to.lights.resize(from.lights.size());
  for (size_t i = 0; i < from.lights.size(); ++i) {
    LightEffects& light = to.lights[i];
    light.light = from.lights[i].light;
    light.touchesView |= from.lights[i].touchesView;
    addAll(light.opaqueCasters, from.lights[i].opaqueCasters);
    addAll(light.perforatedCasters, from.lights[i].perforatedCasters);
    addAll(light.translucentCasters, from.lights[i].translucentCasters);
    addAll(light.media, from.lights[i].media);
    light.penumbra = std::max(light.penumbra, from.lights[i].penumbra);
  }
}

}  // namespace

Effects uniteSteps(std::vector<Effects> steps) {
  Effects all;
  for (Effects& step : steps) {
    addView(all, step);
    all.present = all.present | step.present;
  }
  for (size_t e = 0; e < kEffectCount; ++e) {
    const Effect effect = Effect(e);
    const bool present = all.present.has(effect);
    size_t first = steps.size(), count = 0;
    for (size_t k = 0; k < steps.size(); ++k)
      if (steps[k].present.has(effect)) first = std::min(first, k), ++count;
    all.reason[effect] = present ? "along the path, in " + std::to_string(count) + " of " +
                                       std::to_string(steps.size()) +
                                       " steps: " + steps[first].reason[effect]
                                 : "nowhere along the path: " + steps.back().reason[effect];
  }
  for (Effects& step : steps) all.steps.push_back(std::move(step));
  return all;
}

}  // namespace sb
