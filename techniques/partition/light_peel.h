// Translucent casters peeled from the light: for each layer its depth and the colour behind all
// layers up to it (spec 05, variant P). A lookup structure of arrays, not a partition of what is
// drawn. The number of layers of each group is counted on the device when it is made, for every
// step of a camera's path, so that exactly those are peeled that exist; what lies behind a cap is
// one tail of their product. For a camera that is set freely as many are peeled as there may be.
// Coplanar surfaces of different triangles peel as one layer and lose the other (documented).
#pragma once

#include "techniques/maps/translucent_maps.h"

namespace sb {

/// Casters of one view that are peeled together.
struct PeelGroup {
  size_t view = 0;  ///< index into ShadowMaps::views
  std::vector<uint32_t> instances;
  uint32_t cap = 0;    ///< of layers, the tail not included; at least 1
  uint32_t count = 0;  ///< layers that there are or may be; once arranged: array layers
  uint32_t first = 0;  ///< array layer of the first
  bool tail = false;   ///< the last array layer stands for all behind it
};

class LightPeel {
 public:
  /// Draws what hides casters: the opaque casters of a view.
  using DrawOpaque = std::function<void(rhi::CommandList&, size_t view)>;

  /// Layers that a group has, counted on the device where the camera stands now. Blocks.
  static uint32_t countLayers(const Context& context, ShadowMaps& maps, const PeelGroup& group,
                              const DrawOpaque& drawOpaque);

  /// `steps`: the groups of each step of the camera's path (one if it stands). Creates arrays for
  /// the layers of each, and a tail where there are more than its cap.
  LightPeel(const Context& context, ShadowMaps& maps, std::vector<std::vector<PeelGroup>> steps,
            rhi::Format colourFormat);
  /// Arrays of `layers`, for groups that change with the camera.
  LightPeel(const Context& context, ShadowMaps& maps, uint32_t layers, rhi::Format colourFormat);

  /// No step has groups, and no camera.
  bool empty() const;
  void use(uint32_t step) { m_step = step; }
  /// Of the camera as it stands now: groups that take no more layers than there are.
  void use(std::vector<PeelGroup> groups);
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
  /// Layers that they take, one behind the other.
  static uint32_t arrange(std::vector<PeelGroup>& groups);
  void create(const Context& context, uint32_t layers, bool tails);
  void makeDraws(Step& step) const;
  DrawList layerDraws(const PeelGroup& group, uint32_t layer) const;
  void recordLayer(Frame& frame, const PeelGroup& group, uint32_t layer);
  void recordTail(Frame& frame, const PeelGroup& group);

  const SceneView& m_view;
  ShadowMaps& m_maps;
  bool m_changes = false;  ///< with the camera
  std::vector<Step> m_steps;
  uint32_t m_step = 0;
  rhi::Format m_format;
  rhi::Texture m_depth, m_colour;
  CasterPipelines m_first, m_next, m_tail;
};

}  // namespace sb
