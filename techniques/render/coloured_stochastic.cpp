#include "techniques/render/coloured_stochastic.h"

#include "shaders/common/shared_slots.h"
#include "techniques/render/screen_targets.h"

namespace sb {
namespace {

/// Depths are compared for equality, and products close to one need more than half floats.
constexpr rhi::Format kExact = rhi::Format::RGBA32Float;

constexpr rhi::BlendState kMax = {.enabled = true,
                                  .dstColor = rhi::BlendFactor::One,
                                  .colorOp = rhi::BlendOp::Max,
                                  .dstAlpha = rhi::BlendFactor::One,
                                  .alphaOp = rhi::BlendOp::Max};

}  // namespace

ColouredStochastic::ColouredStochastic(const Context& context, const CameraPass& camera,
                                       uint32_t samples, bool basic)
    : m_samples(samples), m_basic(basic) {
  createTargets(context);
  createPipelines(context, camera);
  std::vector<rhi::Binding> extra = {
      rhi::textureAt(TEXTURE_TRANSPARENCY, camera.depth(), m_sampler)};
  m_unshaded = camera.drawListWith(extra);
  for (uint32_t s = 0; s < 4; ++s)
    extra.push_back(rhi::textureAt(TEXTURE_TRANSPARENCY + 1 + s, depths(s), m_sampler));
  m_shaded = camera.drawListWith(extra);
}

void ColouredStochastic::createTargets(const Context& context) {
  const rhi::FormatCaps caps = context.device.formatCaps(kExact);
  if (!caps.colorTarget || !caps.blend)
    throw rhi::Error("StochasticTransparency", "", "the device cannot blend into RGBA32F");
  const auto texture = [&](const char* label, rhi::Format format) {
    return context.transients.texture(screenTarget(context, label, format), FramePart::Surfaces);
  };
  for (uint32_t s = 0; s < m_samples; ++s)
    m_depths[s] = texture("stochastic depths by channel", kExact);
  if (!m_basic) m_total = texture("total transmittance by channel", kExact);
  m_light = texture("stochastic light", CameraPass::kColorFormat);
  m_hides = texture("stochastic weights", CameraPass::kColorFormat);
  m_sampler = context.device.createSampler(
      {.label = "stochastic transparency sampler", .filter = rhi::Filter::Nearest});
}

void ColouredStochastic::createPipelines(const Context& context, const CameraPass& camera) {
  rhi::GraphicsPipelineDesc depths =
      camera.unshadedPipeline("stochastic_transparency/coloured/depth.frag");
  depths.constants.push_back({32, m_samples});
  depths.targets.assign(m_samples, {.format = kExact, .blend = kMax});
  m_depthPass = context.pipeline(depths);

  rhi::GraphicsPipelineDesc light = camera.translucentPipeline("stochastic_transparency/coloured");
  light.constants.push_back({32, m_samples});
  light.depth = {};
  light.depthFormat = rhi::Format::Undefined;
  light.targets.assign(2, {.format = CameraPass::kColorFormat, .blend = kBlendAdd});
  m_lightPass = context.pipeline(light);

  rhi::GraphicsPipelineDesc composite =
      camera.colouredCompositePipeline("stochastic_transparency/coloured/composite.frag");
  composite.constants = {{32, m_samples}, {33, m_basic}};
  m_composite = context.pipeline(composite);
  if (m_basic) return;
  rhi::GraphicsPipelineDesc total =
      camera.unshadedPipeline("stochastic_transparency/coloured/total.frag");
  total.targets = {{.format = kExact, .blend = kBlendMultiply}};
  m_totalPass = context.pipeline(total);
}

void ColouredStochastic::record(Frame& frame, CameraPass& camera) {
  std::vector<rhi::ResourceUse> reads = {rhi::use(camera.depth(), rhi::Access::Sampled)};
  const auto surfaces = [&](const char* label, std::span<const rhi::ColorAttachment> colors,
                            rhi::PipelineId pipeline, DrawList& draws) {
    camera.surfacePass(
        frame, {.label = label, .colors = colors, .reads = reads},
        [&](rhi::CommandList& commands) { draws.draw(commands, pipeline, camera.translucent()); });
  };
  if (!m_basic) {
    const rhi::ColorAttachment total{.view = {.texture = m_total}, .clear = {1, 1, 1, 1}};
    surfaces("total opacity", {&total, 1}, m_totalPass, m_unshaded);
  }
  std::vector<rhi::ColorAttachment> kept;
  for (uint32_t s = 0; s < m_samples; ++s)
    kept.push_back({.view = {.texture = m_depths[s]}, .clear = {-1, -1, -1, -1}});
  surfaces("stochastic depth", kept, m_depthPass, m_unshaded);
  for (uint32_t s = 0; s < m_samples; ++s)
    reads.push_back(rhi::use(m_depths[s], rhi::Access::Sampled));
  const rhi::ColorAttachment lights[] = {{.view = {.texture = m_light}, .clear = {0, 0, 0, 0}},
                                         {.view = {.texture = m_hides}, .clear = {0, 0, 0, 0}}};
  surfaces("visible colours", lights, m_lightPass, m_shaded);

  reads.erase(reads.begin());
  std::vector<rhi::Binding> bindings;
  // basic has no total and does not read one.
  const rhi::TextureId total = m_basic ? m_light : m_total;
  bindings.push_back(rhi::textureAt(TEXTURE_TRANSPARENCY, total, m_sampler));
  for (uint32_t s = 0; s < 4; ++s)
    bindings.push_back(rhi::textureAt(TEXTURE_TRANSPARENCY + 1 + s, depths(s), m_sampler));
  bindings.push_back(rhi::textureAt(TEXTURE_TRANSPARENCY + 5, m_light, m_sampler));
  bindings.push_back(rhi::textureAt(TEXTURE_TRANSPARENCY + 6, m_hides, m_sampler));
  reads.push_back(rhi::use(m_light, rhi::Access::Sampled));
  reads.push_back(rhi::use(m_hides, rhi::Access::Sampled));
  if (!m_basic) reads.push_back(rhi::use(m_total, rhi::Access::Sampled));
  camera.compositePass(frame, "composite", reads, [&](rhi::CommandList& commands) {
    drawFullscreen(commands, m_composite, bindings);
  });
}

}  // namespace sb
