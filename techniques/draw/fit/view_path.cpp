#include "techniques/draw/fit/view_path.h"

#include <algorithm>
#include <tuple>

#include "techniques/plan/scene_order.h"

namespace sb {
namespace {

// Views are fitted light by light, face by face; both lists are in scene order.
std::tuple<uint32_t, uint32_t> placeOf(const LightView& view) { return {view.light, view.face}; }

}  // namespace

std::vector<LightView> uniteViews(const std::vector<std::vector<LightView>>& steps) {
  std::vector<LightView> united;
  for (const std::vector<LightView>& step : steps)
    for (const LightView& view : step) {
      auto at = std::ranges::lower_bound(united, placeOf(view), {}, placeOf);
      if (at == united.end() || placeOf(*at) != placeOf(view)) {
        united.insert(at, view);
        continue;
      }
      addAll(at->opaque, view.opaque);
      addAll(at->perforated, view.perforated);
      addAll(at->translucent, view.translucent);
    }
  numberLayers(united);
  return united;
}

std::vector<LightView> placeViews(const std::vector<LightView>& united,
                                  std::vector<LightView> step) {
  std::vector<LightView> placed;
  placed.reserve(united.size());
  auto next = step.begin();
  for (const LightView& slot : united) {
    const bool present = next != step.end() && placeOf(*next) == placeOf(slot);
    if (present) {
      placed.push_back(std::move(*next++));
    } else {
      placed.push_back(slot);
      for (auto* casters :
           {&placed.back().opaque, &placed.back().perforated, &placed.back().translucent})
        casters->clear();
    }
    placed.back().layer = placed.back().empty() ? -1 : slot.layer;
  }
  return placed;
}

}  // namespace sb
