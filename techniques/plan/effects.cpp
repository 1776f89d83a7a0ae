#include "techniques/plan/effects.h"

#include <array>

namespace sb {
namespace {

// In the order of the enumeration.
constexpr std::array<std::string_view, kEffectCount> kNames = {
    "opaque-casters",        "perforated-casters",    "translucent-casters",
    "coloured-transmission", "textured-transmission", "translucent-receivers",
    "translucent-overlap",   "area-lights",           "participating-media",
    "multiple-lights",       "local-lights",          "camera-transparency",
    "camera-layers",         "coloured-transparency", "normal-maps",
    "emission"};

}  // namespace

std::string_view effectName(Effect effect) { return kNames.at(size_t(effect)); }

std::vector<Effect> EffectSet::list() const {
  std::vector<Effect> effects;
  for (size_t i = 0; i < kEffectCount; ++i)
    if (has(Effect(i))) effects.push_back(Effect(i));
  return effects;
}

}  // namespace sb
