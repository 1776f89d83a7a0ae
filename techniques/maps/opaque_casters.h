// Opaque and alpha-masked casters in the depth map: what the first pass of most shadow-map
// techniques draws. Pipelines exist for the kinds of casters that there are.
#pragma once

#include <functional>

#include "techniques/maps/shadow_maps.h"

namespace sb {

class OpaqueCasters {
 public:
  /// `maps` must outlive the casters. `change`: what differs from depth alone with one sample.
  OpaqueCasters(const Context& context, ShadowMaps& maps,
                const std::function<void(rhi::GraphicsPipelineDesc&)>& change = {});

  /// Within a pass over the depth map of a view (index into ShadowMaps::views). `copies`: see
  /// DrawList::draw.
  void draw(rhi::CommandList& commands, size_t view, uint32_t copies = 1) const;

 private:
  ShadowMaps* m_maps;
  CasterPipelines m_opaque, m_perforated;
};

}  // namespace sb
