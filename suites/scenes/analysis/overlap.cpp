// Pairs of boxes that overlap in two dimensions, by a sweep along x; stops at the first pair.
#include <algorithm>
#include <functional>

#include "suites/scenes/analysis/parts.h"

namespace sb {
namespace {

struct Item {
  Box box;
  uint32_t instance;
};

// Calls `related(a, b)` for pairs whose boxes, widened by `margin`, overlap in x and y, until it
// returns true.
Overlap sweep(std::vector<Item> items, double margin,
              const std::function<bool(const Item&, const Item&)>& related) {
  std::ranges::sort(items, {}, [](const Item& item) { return item.box.low.x; });
  std::vector<const Item*> active;
  for (const Item& item : items) {
    std::erase_if(active, [&](const Item* a) { return a->box.high.x + margin < item.box.low.x; });
    for (const Item* a : active) {
      if (a->box.high.y + margin < item.box.low.y || item.box.high.y + margin < a->box.low.y)
        continue;
      if (related(*a, item)) return {a->instance, item.instance};
    }
    active.push_back(&item);
  }
  return {};
}

Overlap directionalOverlap(const Analysis& analysis, const LightReach& reach,
                           const std::vector<uint32_t>& casters,
                           const std::function<bool(uint32_t)>& receives) {
  std::vector<Item> items;
  Box all;
  const auto add = [&](uint32_t i) {
    const Mesh& mesh = analysis.scene.meshes[analysis.scene.instances[i].mesh];
    // The mesh's own box, turned into the light's frame, fits closer than the world's box.
    glm::dmat4 toLight = analysis.placed.toWorld(i);
    toLight[3] -= glm::dvec4(analysis.eye, 0);
    toLight = glm::dmat4(reach.axes()) * toLight;
    Box box = transformedBox(meshBox(mesh), toLight);
    box.grow(1e-6 * (box.radius() + glm::length(box.center())));
    all.add(box);
    items.push_back({box, i});
  };
  std::vector<uint8_t> casts(analysis.instances.size());
  for (const uint32_t i : casters) casts[i] = 1, add(i);
  for (uint32_t i = 0; i < analysis.instances.size(); ++i)
    if (!casts[i] && receives(i)) add(i);
  if (items.empty()) return {};
  const double margin = reach.spread() * (all.high.z - all.low.z);
  return sweep(std::move(items), margin, [&](const Item& a, const Item& b) {
    return (casts[a.instance] && receives(b.instance) &&
            LightReach::sweptTouches(a.box, b.box, reach.spread())) ||
           (casts[b.instance] && receives(a.instance) &&
            LightReach::sweptTouches(b.box, a.box, reach.spread()));
  });
}

}  // namespace

Overlap findShadowOverlap(const Analysis& analysis, const LightEffects& light) {
  const auto receives = [&](uint32_t i) {
    const AnalysedInstance& instance = analysis.instances[i];
    return instance.visible && instance.lit && (instance.seeThrough() || instance.passesLight());
  };
  const std::vector<uint32_t>& casters = light.translucentCasters;
  for (const uint32_t i : casters)
    if (receives(i) && !analysis.instances[i].flat) return {i, i};
  const LightReach reach(analysis.placed.light(light.light), analysis.eye);
  if (reach.directional()) return directionalOverlap(analysis, reach, casters, receives);
  for (uint32_t r = 0; r < analysis.instances.size(); ++r) {
    if (!receives(r) || !reach.mayLight(analysis.instances[r].box)) continue;
    for (const uint32_t c : casters)
      if (c != r && reach.mayShadow(analysis.instances[c].box, analysis.instances[r].box))
        return {c, r};
  }
  return {};
}

Overlap findScreenOverlap(const Analysis& analysis) {
  std::vector<Item> items;
  for (uint32_t i = 0; i < analysis.instances.size(); ++i) {
    const AnalysedInstance& instance = analysis.instances[i];
    if (!instance.visible || !instance.seeThrough()) continue;
    if (!instance.flat) return {i, i};
    items.push_back({analysis.view.onScreen(instance.box), i});
  }
  return sweep(std::move(items), 0, [](const Item&, const Item&) { return true; });
}

}  // namespace sb
