// How wide the penumbrae of a light with an extent can be in the picture.
#pragma once

#include <string>

#include "suites/scenes/analysis/parts.h"

namespace sb {

/// An upper bound, in heights of the picture; 0: it throws no soft shadow into the view. `light`:
/// its casters and media.
///
/// From a point of a caster's outline the light spans a half angle a. On a plane at distance h from
/// that point, where the light's middle falls at an angle t to the normal, the penumbra is
/// h (tan(t + a) - tan(t - a)) wide along the slope and less across. Receivers that are not flat
/// may lie along the light, so that only their size in the picture bounds it.
double penumbraBound(const Analysis& analysis, const LightEffects& light);
/// Such a bound (above 0) in words: it may well exceed the picture.
std::string penumbraBoundText(double bound);

}  // namespace sb
