// What a scene calls for, seen through its camera: the input of every plan (design, section 3).
// Conservative throughout: boxes stand for what they hold, so an effect may be reported that no
// pixel shows, never the other way round. All positions are taken relative to the eye, in double.
#pragma once

#include <limits>

#include "techniques/plan/effects.h"
#include "techniques/scene/scene.h"

namespace sb {

/// Analyses `scene` for pictures of `aspect` = width / height through its first camera, at all
/// steps of its path. `rows` of the picture: what is much narrower than one is not called for;
/// without it nothing is too narrow.
Effects analyse(const Scene& scene, double aspect,
                double rows = std::numeric_limits<double>::infinity());

}  // namespace sb
