// What the techniques that multiply colours behind translucent casters share (specs 02 and 05): the
// colour map, its multiplicative pass and the depth it is tested against.
#pragma once

#include "techniques/maps/shadow_maps.h"

namespace sb {

/// Knob `colour`: format of the shadow colour: linear, 8 bits or half floats.
KnobInfo colourFormatKnob();
rhi::Format colourMapFormat(const Knobs& knobs);

/// Draws casters over a colour by multiplication, tested against the opaque depth without writing.
/// A caster coplanar with an opaque surface counts as before it everywhere (spec 02, P6).
rhi::GraphicsPipelineDesc colourPipeline(const Context& context, const ShadowMaps& maps,
                                         const std::string& fragment, rhi::Format format);

/// A pass over one layer of a colour map, which starts white or as it is.
void recordColourPass(Frame& frame, const ShadowMaps& maps, const LightView& view,
                      rhi::TextureId colour, uint32_t layer,
                      const std::function<void(rhi::CommandList&)>& body,
                      rhi::LoadOp load = rhi::LoadOp::Clear);

}  // namespace sb
