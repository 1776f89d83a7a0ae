#include "techniques/maps/opaque_casters.h"

#include <algorithm>

namespace sb {

OpaqueCasters::OpaqueCasters(const Context& context, ShadowMaps& maps,
                             const std::function<void(rhi::GraphicsPipelineDesc&)>& change)
    : m_maps(&maps) {
  const auto any = [&](std::vector<uint32_t> LightView::*casters) {
    return std::ranges::any_of(maps.views(),
                               [&](const LightView& v) { return !(v.*casters).empty(); });
  };
  const auto pipeline = [&](const char* label, const char* fragment, bool masked) {
    rhi::GraphicsPipelineDesc desc = maps.casterPipeline(context, label, fragment, masked);
    if (change) change(desc);
    return maps.pipelines(context, desc);
  };
  if (any(&LightView::opaque)) m_opaque = pipeline("shadow map opaque", "", false);
  if (any(&LightView::perforated))
    m_perforated = pipeline("shadow map perforated", "common/masked.frag", true);
}

void OpaqueCasters::draw(rhi::CommandList& commands, size_t view, uint32_t copies) const {
  const LightView& casters = m_maps->views()[view];
  m_maps->plain(view).draw(commands, m_opaque, casters.opaque, copies);
  m_maps->surfaces(view).draw(commands, m_perforated, casters.perforated, copies);
}

}  // namespace sb
