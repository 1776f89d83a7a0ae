// One light: does it touch the view, and who can throw its shadow there.
#include <algorithm>

#include "suites/scenes/analysis/parts.h"
#include "suites/scenes/analysis/penumbra_bound.h"

namespace sb {
namespace {

// Bounds around everything the light shades in the picture: boxes of visible surfaces and of media
// that scatter, cut to the view.
Box receiverBounds(const Analysis& analysis, const LightReach& reach) {
  Box bounds;
  const auto add = [&](const Box& box, const Box& view) {
    const Box seen = box.clippedTo(view);
    if (!seen.empty() && reach.mayLight(seen)) bounds.add(seen);
  };
  for (const AnalysedInstance& instance : analysis.instances)
    if (instance.visible && instance.lit) add(instance.box, analysis.view.bounds());
  for (const AnalysedMedium& medium : analysis.media)
    if (medium.visible && medium.scatters) add(medium.box, analysis.mediaView);
  return bounds;
}

}  // namespace

LightEffects analyseLight(const Analysis& analysis, uint32_t index) {
  LightEffects light;
  light.light = index;
  const LightReach reach(analysis.placed.light(index), analysis.eye);
  const Box receivers = receiverBounds(analysis, reach);
  light.touchesView = !receivers.empty();
  if (!light.touchesView) return light;

  const Box turned = reach.directional() ? reach.toLightSpace(receivers) : Box();
  const auto mayCast = [&](const Box& box) {
    return reach.directional()
               ? LightReach::sweptTouches(reach.toLightSpace(box), turned, reach.spread())
               : reach.mayShadow(box, receivers);
  };
  for (uint32_t i = 0; i < analysis.instances.size(); ++i) {
    const AnalysedInstance& instance = analysis.instances[i];
    if (!mayCast(instance.box)) continue;
    switch (instance.traits.lightClass) {
      case MaterialClass::Opaque:
        light.opaqueCasters.push_back(i);
        break;
      case MaterialClass::Perforated:
        light.perforatedCasters.push_back(i);
        break;
      case MaterialClass::Translucent:
        light.translucentCasters.push_back(i);
        break;
    }
  }
  for (uint32_t m = 0; m < analysis.media.size(); ++m)
    if (const Box& box = analysis.media[m].box; !box.empty() && mayCast(box))
      light.media.push_back(m);
  light.penumbra = penumbraBound(analysis, light);
  return light;
}

}  // namespace sb
