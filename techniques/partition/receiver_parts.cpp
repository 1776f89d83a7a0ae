#include "techniques/partition/receiver_parts.h"

#include <algorithm>

#include "techniques/draw/views/view_order.h"
#include "techniques/partition/light_batches.h"
#include "techniques/partition/light_order.h"

namespace sb {

ReceiverParts meshParts(const Context& context, const ShadowMaps& maps) {
  const SceneView& view = context.view;
  const std::vector<LightOrder> orders = lightOrder(context, maps, "centre");
  ReceiverParts parts;
  for (const uint32_t mesh : backToFront(view, view.effects().visibleTranslucent)) {
    parts.receivers.push_back({mesh});
    auto& before = parts.casters.emplace_back(orders.size());
    for (size_t v = 0; v < orders.size(); ++v) {
      const std::vector<uint32_t>& order = orders[v].instances();
      before[v].assign(order.begin(), std::ranges::find(order, mesh));
    }
  }
  return parts;
}

ReceiverParts batchParts(const SceneView& view, const ShadowMaps& maps) {
  std::vector<LightOverlap> overlaps;
  for (const LightView& light : maps.views()) overlaps.push_back(lightOverlap(view, light));
  ReceiverParts parts;
  parts.receivers = lightBatches(backToFront(view, view.effects().visibleTranslucent), overlaps);
  for (const std::vector<uint32_t>& part : parts.receivers) {
    auto& before = parts.casters.emplace_back();
    for (const LightOverlap& overlap : overlaps) before.push_back(castersBefore(overlap, part));
  }
  return parts;
}

}  // namespace sb
