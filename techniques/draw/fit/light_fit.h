// What the fits of all kinds of light share. Internal to light_views.
#pragma once

#include <algorithm>
#include <iterator>

#include "techniques/draw/fit/light_views.h"
#include "techniques/draw/fit/seen_part.h"

namespace sb {

struct FitInput {
  const PlacedScene& placed;
  const Camera& camera;
  double aspect;
  const LightFitSettings& settings;
  std::vector<uint32_t> receivers;  ///< instances in the view
  std::vector<Polygon> seen;        ///< around what is seen of them; where local lights are fitted
};

/// A view without casters. `origin` relative to the eye; `texelWidth` as LightView's.
LightView viewThrough(const glm::dmat4& toClip, const glm::dvec3& origin, double texelWidth,
                      const Light& light, uint32_t lightIndex, uint32_t face);

/// Splits the light's casters into the lists of one view by a test of their bounds.
template <class Test>
void assignCasters(LightView& view, const LightEffects& light, const Test& touches) {
  auto filter = [&](const std::vector<uint32_t>& from, std::vector<uint32_t>& to) {
    std::ranges::copy_if(from, std::back_inserter(to), touches);
  };
  filter(light.opaqueCasters, view.opaque);
  filter(light.perforatedCasters, view.perforated);
  filter(light.translucentCasters, view.translucent);
}

/// Distance from the eye beyond which the picture holds no surface.
double farthestReceiver(const FitInput& in);

/// Finds what fitLocal needs of the receivers, once for all lights.
void findSeen(FitInput& in);
/// Views of a spot or point light.
void fitLocal(const FitInput& in, const LightEffects& effects, std::vector<LightView>& out);

}  // namespace sb
