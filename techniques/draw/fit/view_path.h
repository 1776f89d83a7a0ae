// Light views along a scene's path: every view that any step has keeps one place in the list and
// one layer of the map, so that what techniques keep by view stays where it is.
#pragma once

#include <span>

#include "techniques/draw/fit/light_views.h"

namespace sb {

/// The views of all steps, each once, with the casters of all steps; non-empty ones have layers in
/// order. Of one step: that step's views as they are.
std::vector<LightView> uniteViews(const std::vector<std::vector<LightView>>& steps);

/// The views of one step in the places of `united`. What the step lacks is there without casters
/// and without a layer.
std::vector<LightView> placeViews(const std::vector<LightView>& united,
                                  std::vector<LightView> step);

}  // namespace sb
