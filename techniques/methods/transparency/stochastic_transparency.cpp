// Stochastic transparency (Enderton, Sintorn, Shirley, Luebke 2010); spec 15, D. Each fragment
// keeps a random share of a pixel's samples, as large as its opacity; ordinary depth tests do the
// rest.
//   mode=basic      one pass and a composite: right in expectation, noise q (1 - q) / S
//   mode=corrected  opacity of all layers together (exact, by blending), stochastic depths, colours
//                   weighted by visibility, composite: four passes, far less noise, a small bias
// With samples=4 the edges of translucent surfaces are those of the samples, not of pixel centres,
// and each triangle that shares a pixel draws numbers of its own.
// Where the scene has glass, samples are kept by channel: ColouredStochastic.
// Surfaces in one plane are layers in the order of their keys (CoplanarSurfaces).
#include "shaders/common/shared_slots.h"
#include "techniques/render/coloured_stochastic.h"
#include "techniques/render/registry.h"
#include "techniques/render/screen_targets.h"

namespace sb {
namespace {

/// A product of opacities close to one needs more than half floats.
constexpr rhi::Format kTransmittanceFormat = rhi::Format::R32Float;

class StochasticTransparency final : public TransparencyTechnique {
 public:
  void prepare(const Context& context, CameraPass& camera) override {
    m_samples = context.knobs.integer("samples");
    m_basic = context.knobs.is("mode", "basic");
    if (context.plan.runs(Effect::ColouredTransparency)) {
      m_coloured.emplace(context, camera, m_samples, m_basic);
      return;
    }
    createTargets(context, camera);
    createPipelines(context, camera);
    const rhi::Binding opaque = rhi::textureAt(TEXTURE_TRANSPARENCY, camera.depth(), m_sampler);
    m_draws = camera.drawListWith({&opaque, 1});
  }

  void record(Frame& frame, CameraPass& camera) override {
    if (m_coloured) {
      m_coloured->record(frame, camera);
      return;
    }
    const rhi::ResourceUse opaque = rhi::use(camera.depth(), rhi::Access::Sampled);
    auto draw = [&](rhi::PipelineId pipeline) {
      return [this, pipeline, &camera](rhi::CommandList& commands) {
        m_draws.draw(commands, pipeline, camera.translucent());
      };
    };
    rhi::DepthAttachment depth{.view = {.texture = m_depth}, .clearDepth = CameraPass::kFarDepth};
    if (!m_basic) {
      const rhi::ColorAttachment total{.view = {.texture = m_transmittance}, .clear = {1, 1, 1, 1}};
      camera.surfacePass(
          frame, {.label = "total opacity", .colors = std::span(&total, 1), .reads = {&opaque, 1}},
          draw(m_total));
      camera.surfacePass(frame,
                         {.label = "stochastic depth", .depth = depth, .reads = {&opaque, 1}},
                         draw(m_depths));
      depth.load = rhi::LoadOp::Load;
      depth.readOnly = true;
    }
    rhi::ColorAttachment color{.view = {.texture = m_colors}};
    if (m_samples > 1) color.resolve = rhi::TextureView{.texture = m_resolved};
    camera.surfacePass(frame,
                       {.label = m_basic ? "stochastic colours" : "visible colours",
                        .colors = std::span(&color, 1),
                        .depth = depth,
                        .reads = {&opaque, 1}},
                       draw(m_surfaces));
    composite(frame, camera);
  }

 private:
  void createTargets(const Context& context, const CameraPass& camera) {
    auto texture = [&](rhi::TextureDesc desc, uint32_t samples) {
      const rhi::FormatCaps caps = context.device.formatCaps(desc.format);
      const rhi::FormatInfo& format = rhi::formatInfo(desc.format);
      const bool blends = caps.blend || m_basic || format.depth;
      if (!blends || std::ranges::count(caps.sampleCounts, samples) == 0)
        throw rhi::Error("StochasticTransparency", "",
                         "the device has no " + std::string(format.name) + " targets of " +
                             std::to_string(samples) + " samples that blend");
      desc.samples = samples;
      return context.transients.texture(desc, FramePart::Surfaces);
    };
    const auto colour = [&](const char* label) {
      return screenTarget(context, label, CameraPass::kColorFormat);
    };
    m_depth = texture(screenTarget(context, "stochastic depths", camera.depthFormat(),
                                   rhi::TextureUse::DepthTarget),
                      m_samples);
    m_colors = texture(colour("stochastic colours"), m_samples);
    if (m_samples > 1) m_resolved = texture(colour("stochastic colours resolved"), 1);
    if (!m_basic)
      m_transmittance =
          texture(screenTarget(context, "total transmittance", kTransmittanceFormat), 1);
    m_sampler = context.device.createSampler(
        {.label = "stochastic transparency sampler", .filter = rhi::Filter::Nearest});
  }

  void createPipelines(const Context& context, CameraPass& camera) {
    rhi::GraphicsPipelineDesc surfaces = camera.translucentPipeline("stochastic_transparency");
    surfaces.samples = m_samples;
    surfaces.constants.push_back({32, m_samples});
    surfaces.constants.push_back({33, m_basic});
    if (m_basic)
      surfaces.depth = {.test = true, .write = true, .compare = CameraPass::kNearerOrEqual};
    else
      surfaces.targets.front().blend = {
          .enabled = true, .dstColor = rhi::BlendFactor::One, .dstAlpha = rhi::BlendFactor::One};
    m_surfaces = context.pipeline(surfaces);
    rhi::GraphicsPipelineDesc composite =
        camera.compositePipeline("stochastic_transparency/composite.frag");
    composite.constants = {{33, m_basic}};
    m_composite = context.pipeline(composite);
    if (m_basic) return;

    rhi::GraphicsPipelineDesc total = camera.unshadedPipeline("stochastic_transparency/total.frag");
    total.targets = {{.format = kTransmittanceFormat,
                      .blend = {.enabled = true,
                                .srcColor = rhi::BlendFactor::Zero,
                                .dstColor = rhi::BlendFactor::SrcColor,
                                .srcAlpha = rhi::BlendFactor::Zero,
                                .dstAlpha = rhi::BlendFactor::One}}};
    m_total = context.pipeline(total);
    rhi::GraphicsPipelineDesc depths =
        camera.unshadedPipeline("stochastic_transparency/depth.frag");
    depths.samples = m_samples;
    depths.constants.push_back({32, m_samples});
    depths.depth = {.test = true, .write = true, .compare = CameraPass::kNearerOrEqual};
    depths.depthFormat = camera.depthFormat();
    m_depths = context.pipeline(depths);
  }

  void composite(Frame& frame, CameraPass& camera) {
    const rhi::TextureId samples = m_samples > 1 ? m_resolved : m_colors;
    // basic has no second texture and does not read one.
    const rhi::TextureId total = m_basic ? samples : m_transmittance;
    const rhi::Binding bindings[] = {rhi::textureAt(TEXTURE_TRANSPARENCY, samples, m_sampler),
                                     rhi::textureAt(TEXTURE_TRANSPARENCY + 1, total, m_sampler)};
    const rhi::ResourceUse reads[] = {rhi::use(samples, rhi::Access::Sampled),
                                      rhi::use(total, rhi::Access::Sampled)};
    camera.compositePass(
        frame, "composite", std::span(reads, m_basic ? 1 : 2),
        [&](rhi::CommandList& commands) { drawFullscreen(commands, m_composite, bindings); });
  }

  uint32_t m_samples = 1;
  bool m_basic = false;
  std::optional<ColouredStochastic> m_coloured;
  rhi::TextureId m_depth, m_colors, m_resolved, m_transmittance;
  rhi::Sampler m_sampler;
  rhi::PipelineId m_surfaces, m_total, m_depths, m_composite;
  DrawList m_draws;
};

REGISTER_TECHNIQUE(
    TransparencyTechnique, StochasticTransparency,
    (TechniqueInfo{
        .name = "StochasticTransparency",
        .folder = "stochastic_transparency",
        .title = "Stochastic transparency",
        .paper = "Enderton, Sintorn, Shirley, Luebke 2010",
        .represents = {Effect::CameraTransparency, Effect::CameraLayers,
                       Effect::ColouredTransparency},
        .requiresFor = {{Effect::ColouredTransparency, rhi::Feature::DualSourceBlend}},
        .knobs = {{.name = "samples",
                   .help = "of a pixel, of which each surface keeps a random share",
                   .fallback = "4",
                   .choices = {"1", "4"},
                   .sweep = {"1", "4"}},
                  {.name = "mode",
                   .help = "corrected by the exact opacity of all layers, or as it comes",
                   .fallback = "corrected",
                   .choices = {"corrected", "basic"}}},
        .error = "basic: noise alone; corrected: less noise, colours of several layers biased",
        .stochastic = true,
        // With one sample of two half-opaque layers the front one gets 9/16 instead of 1/2.
        .breaksIn = {
            {"camera far samples:1",
             "the correction divides by a sum of random weights, which biases colours"}}}));

}  // namespace
}  // namespace sb
