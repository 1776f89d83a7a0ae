// Translucent casters peeled from the light: for each layer its depth and the colour behind all
// layers up to it (spec 05, variant P). A lookup structure of arrays, not a partition of what is
// drawn. The number of layers of each group is counted on the device when it is made, for every
// step of a camera's path, so that exactly those are peeled that exist; what lies behind a cap is
// one tail of their product.
// Coplanar surfaces of different triangles peel as one layer and lose the other (documented).
#pragma once

#include "techniques/maps/translucent_maps.h"

namespace sb {

/// Casters of one view that are peeled together.
struct PeelGroup {
  size_t view = 0;  ///< index into ShadowMaps::views
  std::vector<uint32_t> instances;
  uint32_t first = 0;  ///< array layer of the first
  uint32_t count = 0;  ///< array layers, the tail included
  bool tail = false;   ///< the last layer stands for all behind it
};

class LightPeel {
 public:
  /// Draws what hides casters: the opaque casters of a view.
  using DrawOpaque = std::function<void(rhi::CommandList&, size_t view)>;

  /// Layers that a group has, counted on the device where the camera stands now. Blocks.
  static uint32_t countLayers(const Context& context, ShadowMaps& maps, const PeelGroup& group,
                              const DrawOpaque& drawOpaque);

  /// `steps`: the groups of each step of the camera's path (one if it stands), in PeelGroup::count
  /// the layers that were counted. Creates arrays for at most `cap` layers a group, and a tail
  /// where there are more.
  LightPeel(const Context& context, ShadowMaps& maps, std::vector<std::vector<PeelGroup>> steps,
            uint32_t cap, rhi::Format colourFormat);

  /// No step has groups.
  bool empty() const;
  void use(uint32_t step) { m_step = step; }
  const std::vector<PeelGroup>& groups() const { return m_steps[m_step].groups; }
  /// Records the peeling of all groups. The opaque depth of their views must be there.
  void record(Frame& frame);

  const rhi::Texture& depth() const { return m_depth; }
  const rhi::Texture& colour() const { return m_colour; }

 private:
  struct Step {
    std::vector<PeelGroup> groups;
    std::vector<DrawList> draws;  ///< by array layer
  };
  DrawList layerDraws(const Context& context, const PeelGroup& group, uint32_t layer) const;
  void recordLayer(Frame& frame, const PeelGroup& group, uint32_t layer);
  void recordTail(Frame& frame, const PeelGroup& group);

  ShadowMaps& m_maps;
  std::vector<Step> m_steps;
  uint32_t m_step = 0;
  rhi::Format m_format;
  rhi::Texture m_depth, m_colour;
  CasterPipelines m_first, m_next, m_tail;
};

}  // namespace sb
