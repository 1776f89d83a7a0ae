#include "techniques/common/depth_compare.h"

#include "shaders/common/shared_slots.h"

namespace sb {

KnobInfo compareKnob(const std::string& fallback) {
  return {.name = "compare",
          .help =
              "2x2 hardware comparison at every tap (in the shader where the device "
              "filters no depth), or one exact texel a tap",
          .fallback = fallback,
          .choices = {"hardware", "manual"}};
}

DepthCompare::DepthCompare(const Context& context, const ShadowMaps& maps) {
  const bool filters = context.device.formatCaps(maps.depthFormat()).linearFilter;
  m_sampler = context.device.createSampler(
      {.label = "shadow map compare",
       .filter = filters ? rhi::Filter::Linear : rhi::Filter::Nearest,
       .addressU = rhi::AddressMode::ClampToBorder,
       .addressV = rhi::AddressMode::ClampToBorder,
       .border = rhi::BorderColor::TransparentBlack,  // outside the map is lit (spec 01, P1)
       .compare = rhi::CompareOp::GreaterOrEqual});
  m_constants = {{19, context.knobs.is("compare", "hardware")}, {20, !filters}};
}

std::vector<rhi::Binding> DepthCompare::bindings(const ShadowMaps& maps) const {
  return {rhi::textureAt(TEXTURE_TECHNIQUE, maps.depth(), maps.pointSampler()),
          rhi::textureAt(TEXTURE_TECHNIQUE + 1, maps.depth(), m_sampler)};
}

}  // namespace sb
