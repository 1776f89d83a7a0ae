// Levels of all light views together (spec 05, variants L and P): which layer of one colour map
// lies behind which level, and which peeled group a receiver reads.
#pragma once

#include "techniques/maps/shadow_maps.h"
#include "techniques/partition/light_levels.h"

namespace sb {

class ViewLevels {
 public:
  /// Of the views where the camera stands. `peeled`: one level on which everything is peeled, else
  /// at most `cap` levels.
  void plan(const SceneView& view, const ShadowMaps& maps, bool peeled, uint32_t cap);

  /// Layers that the colour map needs.
  uint32_t layers() const { return m_layers; }
  const LightLevels& of(size_t view) const { return m_views[view].levels; }
  /// Layer of the colour map behind a level of a view.
  uint32_t layer(size_t view, uint32_t level) const { return m_views[view].firstLayer + level; }
  /// 1 + layer of the colour behind the first `levels` levels; 0 behind none.
  uint32_t layerBehind(size_t view, uint32_t levels) const;
  /// Groups that have to be peeled, without their counts.
  std::vector<PeelGroup> groups() const;
  /// The group of a level among those that are peeled, or null.
  const PeelGroup* group(const std::optional<LightPeel>& peel, size_t view, uint32_t level) const;

 private:
  struct View {
    LightLevels levels;
    uint32_t firstLayer = 0;  ///< of the colour map: behind level 0
  };
  std::vector<View> m_views;
  uint32_t m_layers = 0;
};

}  // namespace sb
