// Translucent casters peeled from the light: for each layer its depth and the colour behind all
// layers up to it (spec 05, variant P). A lookup structure of arrays, not a partition of what is
// drawn. The number of layers of each group is counted once on the device when it is made, so that
// exactly those are peeled that exist; what lies behind a cap is one tail of their product.
// Coplanar surfaces of different triangles peel as one layer and lose the other (documented).
#pragma once

#include "techniques/common/translucent_maps.h"

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
  /// Counts the layers of each group (`drawOpaque(commands, view)` draws what hides casters), and
  /// creates arrays for at most `cap` layers a group, and a tail where there are more.
  LightPeel(const Context& context, ShadowMaps& maps, std::vector<PeelGroup> groups, uint32_t cap,
            rhi::Format colourFormat,
            const std::function<void(rhi::CommandList&, size_t view)>& drawOpaque);

  const std::vector<PeelGroup>& groups() const { return m_groups; }
  /// Records the peeling of all groups. The opaque depth of their views must be there.
  void record(Frame& frame);

  const rhi::Texture& depth() const { return m_depth; }
  const rhi::Texture& colour() const { return m_colour; }

 private:
  uint32_t countLayers(const Context& context, const PeelGroup& group,
                       const std::function<void(rhi::CommandList&, size_t)>& drawOpaque);
  DrawList layerDraws(const Context& context, const PeelGroup& group, uint32_t layer) const;
  void recordLayer(Frame& frame, const PeelGroup& group, uint32_t layer);
  void recordTail(Frame& frame, const PeelGroup& group);

  ShadowMaps& m_maps;
  std::vector<PeelGroup> m_groups;
  rhi::Format m_format;
  rhi::Texture m_depth, m_colour;
  rhi::PipelineId m_first, m_next, m_tail;
  std::vector<DrawList> m_draws;  ///< by array layer
};

}  // namespace sb
