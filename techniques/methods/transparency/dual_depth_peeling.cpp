// Dual depth peeling (Bavoil, Myers 2008); spec 15, C. Each pass peels two layers, the nearest and
// the farthest that are left: their depths come from the pass before by MAX blending of (depth,
// -depth), front layers are blended under, back layers over. One pass without shading, then ceil(k /
// 2) with three targets. Where the scene has glass, each pass writes its two layers with their
// weights to four targets beside the bounds; two full-screen passes slide the front one under the
// others (ColouredLayers) and lay the back one over the picture. Exact up to `layers`; what is left
// in the middle beyond that is lost. Surfaces in one plane are layers in the order of their keys.
//   stop=query  runs as many passes as the last frame needed; an occlusion query over the bounds
//               that are left (a draw of the composite pass) proves that they were enough
//   stop=count  always peels ceil(layers / 2) times
#include <algorithm>

#include "shaders/common/shared_slots.h"
#include "techniques/draw/frame/pass_queries.h"
#include "techniques/render/coloured_layers.h"
#include "techniques/render/screen_targets.h"

namespace sb {
namespace {

/// Float depths need float bounds: MAX of them decides which fragments are equal to a bound.
constexpr rhi::Format kBoundsFormat = rhi::Format::RG32Float;
constexpr std::array<float, 4> kNothing = {-2, -2, 0, 0};

constexpr rhi::BlendState kMax = {.enabled = true,
                                  .dstColor = rhi::BlendFactor::One,
                                  .colorOp = rhi::BlendOp::Max,
                                  .dstAlpha = rhi::BlendFactor::One,
                                  .alphaOp = rhi::BlendOp::Max};
// Both sides keep their transmittance in alpha.
constexpr rhi::BlendState kUnder = {.enabled = true,
                                    .srcColor = rhi::BlendFactor::DstAlpha,
                                    .dstColor = rhi::BlendFactor::One,
                                    .srcAlpha = rhi::BlendFactor::Zero,
                                    .dstAlpha = rhi::BlendFactor::OneMinusSrcAlpha};
constexpr rhi::BlendState kOver = {.enabled = true,
                                   .dstColor = rhi::BlendFactor::OneMinusSrcAlpha,
                                   .srcAlpha = rhi::BlendFactor::Zero,
                                   .dstAlpha = rhi::BlendFactor::OneMinusSrcAlpha};

class DualDepthPeeling final : public TransparencyTechnique {
 public:
  void prepare(const Context& context, CameraPass& camera) override {
    m_most = (context.knobs.integer("layers") + 1) / 2;
    // As in depth peeling: a camera that is set freely has no frame before it to learn from.
    m_byQuery = context.knobs.is("stop", "query") && !context.view.isFree();
    if (m_byQuery) m_queries = PassQueries(context.device, "dual depth peeling", m_most + 1);
    m_coloured = context.plan.runs(Effect::ColouredTransparency);
    createTargets(context);

    rhi::GraphicsPipelineDesc init = camera.unshadedPipeline("dual_depth_peeling/init.frag");
    init.targets = {{.format = kBoundsFormat, .blend = kMax}};
    m_init = context.pipeline(init);
    rhi::GraphicsPipelineDesc peel = camera.translucentPipeline(
        m_coloured ? "dual_depth_peeling/coloured" : "dual_depth_peeling");
    peel.depth = {};
    peel.depthFormat = rhi::Format::Undefined;
    peel.targets = {{.format = kBoundsFormat, .blend = kMax},
                    {.format = CameraPass::kColorFormat, .blend = kUnder},
                    {.format = CameraPass::kColorFormat, .blend = kOver}};
    if (m_coloured) {
      const rhi::ColorTargetState light{.format = CameraPass::kColorFormat, .blend = kBlendAdd};
      const rhi::ColorTargetState weight{.format = CameraPass::kColorFormat,
                                         .blend = kBlendMultiply};
      peel.targets = {peel.targets.front(), light, weight, light, weight};
      m_layers = ColouredLayers(context, camera);
    }
    m_peel = context.pipeline(peel);
    if (!m_coloured)
      m_composite = context.pipeline(camera.compositePipeline("dual_depth_peeling/composite.frag"));
    rhi::GraphicsPipelineDesc left = camera.compositePipeline("dual_depth_peeling/left.frag");
    left.targets.front() = {.format = CameraPass::kColorFormat, .writeMask = 0};
    if (m_byQuery) m_left = context.pipeline(left);

    const rhi::Binding opaque = rhi::textureAt(TEXTURE_TRANSPARENCY, camera.depth(), m_sampler);
    m_all = camera.drawListWith({&opaque, 1});
    for (const rhi::TextureId bounds : m_bounds) {
      const rhi::Binding extra[] = {opaque,
                                    rhi::textureAt(TEXTURE_TRANSPARENCY + 1, bounds, m_sampler)};
      m_between.push_back(camera.drawListWith(extra));
    }
  }

  void record(Frame& frame, CameraPass& camera) override {
    const uint32_t passes = passesToRun(camera.view().step());
    const rhi::ColorAttachment bounds{.view = {.texture = m_bounds[0]}, .clear = kNothing};
    const rhi::ResourceUse opaque = rhi::use(camera.depth(), rhi::Access::Sampled);
    camera.surfacePass(
        frame,
        {.label = "nearest and farthest", .colors = std::span(&bounds, 1), .reads = {&opaque, 1}},
        [&](rhi::CommandList& commands) { m_all.draw(commands, m_init, camera.translucent()); });
    for (uint32_t i = 0; i < passes; ++i) {
      peel(frame, camera, i);
      if (!m_coloured) continue;
      m_layers.slideUnder(frame, {m_front, m_frontBehind}, i == 0);
      m_layers.layOver(frame, camera, {m_back, m_backBehind});
    }
    composite(frame, camera, m_bounds[passes % 2]);
  }

  std::vector<std::string> warnings() override {
    const std::vector<uint64_t> samples = m_queries.look();
    if (samples.size() <= m_most || samples.back() == 0) return {};
    return {"dual depth peeling has layers left after " + std::to_string(m_most) +
            " passes: those in the middle are missing (knob layers)"};
  }

 private:
  void createTargets(const Context& context) {
    const rhi::FormatCaps caps = context.device.formatCaps(kBoundsFormat);
    if (!caps.colorTarget || !caps.blend)
      throw rhi::Error("DualDepthPeeling", "", "the device cannot blend into RG32F");
    const auto texture = [&](const char* label, rhi::Format format) {
      return context.transients.texture(screenTarget(context, label, format), FramePart::Surfaces);
    };
    for (rhi::TextureId& bounds : m_bounds) bounds = texture("dual peeling bounds", kBoundsFormat);
    m_front = texture("dual peeling front layers", CameraPass::kColorFormat);
    m_back = texture("dual peeling back layers", CameraPass::kColorFormat);
    if (m_coloured) {
      m_frontBehind = texture("dual peeling front weights", CameraPass::kColorFormat);
      m_backBehind = texture("dual peeling back weights", CameraPass::kColorFormat);
    }
    m_sampler = context.device.createSampler(
        {.label = "dual peeling sampler", .filter = rhi::Filter::Nearest});
  }

  /// As many as drew something in the last frame (of this step), if nothing was left behind them;
  /// else all.
  uint32_t passesToRun(uint32_t step) {
    if (!m_byQuery) return m_most;
    std::vector<uint64_t> samples = m_atSteps.next(m_queries.take(), step);
    if (samples.empty() || samples.back() > 0) return m_most;
    samples.pop_back();
    return uint32_t(std::ranges::find(samples, 0u) - samples.begin());
  }

  void peel(Frame& frame, CameraPass& camera, uint32_t i) {
    const rhi::LoadOp load = i == 0 ? rhi::LoadOp::Clear : rhi::LoadOp::Load;
    std::vector<rhi::ColorAttachment> colors = {
        {.view = {.texture = m_bounds[(i + 1) % 2]}, .clear = kNothing},
        {.view = {.texture = m_front}, .load = load, .clear = {0, 0, 0, 1}},
        {.view = {.texture = m_back}, .load = load, .clear = {0, 0, 0, 1}}};
    if (m_coloured)
      colors = {colors.front(),
                {.view = {.texture = m_front}, .clear = {0, 0, 0, 0}},
                {.view = {.texture = m_frontBehind}, .clear = {1, 1, 1, 1}},
                {.view = {.texture = m_back}, .clear = {0, 0, 0, 0}},
                {.view = {.texture = m_backBehind}, .clear = {1, 1, 1, 1}}};
    const rhi::ResourceUse reads[] = {rhi::use(camera.depth(), rhi::Access::Sampled),
                                      rhi::use(m_bounds[i % 2], rhi::Access::Sampled)};
    camera.surfacePass(
        frame, {.label = "peel both sides", .colors = colors, .reads = reads},
        [&](rhi::CommandList& commands) {
          counted(commands, [&] { m_between[i % 2].draw(commands, m_peel, camera.translucent()); });
        });
  }

  void composite(Frame& frame, CameraPass& camera, rhi::TextureId bounds) {
    if (m_coloured) {
      const rhi::Binding binding = rhi::textureAt(TEXTURE_TRANSPARENCY + 2, bounds, m_sampler);
      const rhi::ResourceUse read = rhi::use(bounds, rhi::Access::Sampled);
      m_layers.composite(frame, camera, {&read, 1}, [&](rhi::CommandList& commands) {
        if (m_byQuery) counted(commands, [&] { drawFullscreen(commands, m_left, {&binding, 1}); });
      });
      return;
    }
    const rhi::Binding bindings[] = {rhi::textureAt(TEXTURE_TRANSPARENCY, m_front, m_sampler),
                                     rhi::textureAt(TEXTURE_TRANSPARENCY + 1, m_back, m_sampler),
                                     rhi::textureAt(TEXTURE_TRANSPARENCY + 2, bounds, m_sampler)};
    const rhi::ResourceUse reads[] = {rhi::use(m_front, rhi::Access::Sampled),
                                      rhi::use(m_back, rhi::Access::Sampled),
                                      rhi::use(bounds, rhi::Access::Sampled)};
    camera.compositePass(frame, "composite", reads, [&](rhi::CommandList& commands) {
      drawFullscreen(commands, m_composite, bindings);
      if (m_byQuery) counted(commands, [&] { drawFullscreen(commands, m_left, bindings); });
    });
  }

  void counted(rhi::CommandList& commands, const std::function<void()>& draws) {
    if (m_byQuery)
      m_queries.count(commands, draws);
    else
      draws();
  }

  bool m_coloured = false;
  ColouredLayers m_layers;
  uint32_t m_most = 0;
  bool m_byQuery = false;
  PassQueries m_queries;  ///< of each peeling pass, and last of what is left
  PassesAtSteps m_atSteps;
  rhi::TextureId m_bounds[2], m_front, m_back, m_frontBehind, m_backBehind;
  rhi::Sampler m_sampler;
  rhi::PipelineId m_init, m_peel, m_composite, m_left;
  DrawList m_all;
  std::vector<DrawList> m_between;  ///< the bounds in m_bounds[0], in m_bounds[1]
};

REGISTER_TECHNIQUE(
    TransparencyTechnique, DualDepthPeeling,
    (TechniqueInfo{
        .name = "DualDepthPeeling",
        .folder = "dual_depth_peeling",
        .title = "Dual depth peeling, from both sides",
        .paper = "Bavoil, Myers 2008",
        .represents = {Effect::CameraTransparency, Effect::CameraLayers,
                       Effect::ColouredTransparency},
        .requires_ = {rhi::Feature::PreciseOcclusion, rhi::Feature::IndependentBlend},
        .requiresFor = {{Effect::ColouredTransparency, rhi::Feature::DualSourceBlend}},
        .knobs = {{.name = "stop",
                   .help = "peeling ends when nothing is left, or after a fixed count",
                   .fallback = "query",
                   .choices = {"query", "count"}},
                  {.name = "layers",
                   .help = "most layers a pixel (stop=count: always as many)",
                   .fallback = "32",
                   .min = 1,
                   .max = 64,
                   .sweep = {"2", "4", "8"}}},
        .error = "none up to the number of layers; those in the middle are lost first",
        .breaksIn = {{"camera layers", "the middle ones of more than `layers` are lost"}}}));

}  // namespace
}  // namespace sb
