#include "techniques/partition/view_levels.h"

#include <algorithm>

namespace sb {

void ViewLevels::plan(const SceneView& view, const ShadowMaps& maps, bool peeled, uint32_t cap) {
  m_layers = 0;
  m_views.assign(maps.views().size(), {});
  for (size_t i = 0; i < m_views.size(); ++i) {
    if (maps.views()[i].layer < 0) continue;
    const LightOverlap overlap = lightOverlap(view, maps.views()[i]);
    LightLevels& levels = m_views[i].levels;
    levels = peeled ? onePeeledLevel(overlap) : lightLevels(overlap, cap);
    m_views[i].firstLayer = m_layers;
    if (!peeled) m_layers += uint32_t(levels.casters.size());
  }
}

uint32_t ViewLevels::layerBehind(size_t view, uint32_t levels) const {
  const uint32_t there = uint32_t(m_views[view].levels.casters.size());
  return levels == 0 || there == 0 ? 0 : m_views[view].firstLayer + std::min(levels, there);
}

std::vector<PeelGroup> ViewLevels::groups() const {
  std::vector<PeelGroup> groups;
  for (size_t i = 0; i < m_views.size(); ++i)
    for (const auto& instances : m_views[i].levels.peeled)
      if (!instances.empty()) groups.push_back({.view = i, .instances = instances});
  return groups;
}

const PeelGroup* ViewLevels::group(const std::optional<LightPeel>& peel, size_t view,
                                   uint32_t level) const {
  if (!peel || level >= m_views[view].levels.peeled.size()) return nullptr;
  const auto& wanted = m_views[view].levels.peeled[level];
  for (const PeelGroup& g : peel->groups())
    if (g.view == view && g.instances == wanted) return &g;
  return nullptr;
}

}  // namespace sb
