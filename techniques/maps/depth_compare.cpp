#include "techniques/maps/depth_compare.h"

#include "shaders/common/shared_slots.h"

namespace sb {

KnobInfo compareKnob() {
  return {.name = "compare",
          .help =
              "2x2 comparisons at every tap, weighed as hardware does (by it in a kernel of 1, "
              "where the device filters depth; else in the shader), or one exact texel a tap",
          .fallback = "manual",
          .choices = {"hardware", "manual"}};
}

DepthCompare::DepthCompare(const Context& context, const ShadowMaps& maps, uint32_t samples)
    : m_samples(samples) {
  const Knobs& knobs = context.knobs;
  const bool hardware = knobs.is("compare", "hardware");
  if (samples > 1 && hardware)
    throw rhi::Error("knob compare", "", "no hardware compares maps of several samples a texel");
  const uint32_t kernel = knobs.integer("kernel");
  if (samples == 1 && !hardware && knobs.is("shape", "box")) m_equalTexels = kernel * kernel;
  m_constants = {{21, samples}};
  if (samples > 1) return;
  const bool filters = context.device.formatCaps(maps.depthFormat()).linearFilter;
  m_sampler = context.device.createSampler(
      {.label = "shadow map compare",
       .filter = filters ? rhi::Filter::Linear : rhi::Filter::Nearest,
       .addressU = rhi::AddressMode::ClampToBorder,
       .addressV = rhi::AddressMode::ClampToBorder,
       .border = rhi::BorderColor::TransparentBlack,  // outside the map is lit (spec 01, P1)
       .compare = rhi::CompareOp::GreaterOrEqual});
  m_constants.push_back({19, hardware});
  m_constants.push_back({20, !filters});
}

VisibilityInputs DepthCompare::inputs(const ShadowMaps& maps,
                                      const std::vector<rhi::SpecConstant>& constants,
                                      const std::string& samplesFolder) const {
  VisibilityInputs inputs{
      .bindings = {rhi::textureAt(TEXTURE_TECHNIQUE, maps.depth(), maps.pointSampler())},
      .reads = {rhi::use(maps.depth().id(), rhi::Access::Sampled)},
      .constants = constants};
  inputs.constants.insert(inputs.constants.end(), m_constants.begin(), m_constants.end());
  if (m_samples > 1)
    inputs.folder = samplesFolder;
  else
    inputs.bindings.push_back(rhi::textureAt(TEXTURE_TECHNIQUE + 1, maps.depth(), m_sampler));
  return inputs;
}

}  // namespace sb
