// Depth peeling (Everitt 2001); spec 15, B. Each pass draws all translucent surfaces and keeps, per
// pixel, the nearest fragment behind the layer before; a full-screen pass slides it under the
// layers so far. k + 1 peeling passes for k layers, each with its own shading; two depth buffers,
// two colour targets (five where the scene has glass: ColouredLayers). Exact up to `layers`;
// surfaces in one plane are layers in the order of their keys (CoplanarSurfaces), and what lies
// behind the last layer is lost: an error of at most the product of (1 - a) in front of it. Where
// the shadow technique answers by layers, the depth of each is drawn first, in a pass of its own.
//   stop=query  stops behind the first empty layer, which an occlusion query found a frame earlier
//               (of a camera in motion: a loop earlier, at the same place)
//   stop=count  always peels `layers` times
#include <algorithm>

#include "shaders/common/shared_slots.h"
#include "techniques/draw/frame/pass_queries.h"
#include "techniques/render/coloured_layers.h"
#include "techniques/render/screen_targets.h"

namespace sb {
namespace {

class DepthPeeling final : public TransparencyTechnique {
 public:
  void prepare(const Context& context, CameraPass& camera) override {
    m_most = context.knobs.integer("layers");
    // What a camera found elsewhere says nothing of one that is set freely: all layers are peeled.
    m_byQuery = context.knobs.is("stop", "query") && !context.view.isFree();
    if (m_byQuery) m_queries = PassQueries(context.device, "depth peeling layers", m_most);
    m_coloured = context.plan.runs(Effect::ColouredTransparency);
    createTargets(context, camera);
    createPipelines(context, camera);

    // The first layer has none before it; what stands in that slot is not read.
    const rhi::TextureId before[] = {camera.depth(), m_depth[0], m_depth[1]};
    for (const rhi::TextureId depth : before) {
      const rhi::Binding extra[] = {rhi::textureAt(TEXTURE_TRANSPARENCY, camera.depth(), m_sampler),
                                    rhi::textureAt(TEXTURE_TRANSPARENCY + 1, depth, m_sampler)};
      m_behind.push_back(camera.drawListWith(extra));
    }
  }

  void record(Frame& frame, CameraPass& camera) override {
    const uint32_t layers = layersToPeel(camera.view().step());
    for (uint32_t layer = 0; layer < layers; ++layer) {
      camera.recordLayer(
          frame, {.depth = m_depth[layer % 2], .index = layer + 1},
          [&] { drawDepth(frame, camera, layer); }, [&] { peel(frame, camera, layer); });
      if (m_coloured)
        m_under.slideUnder(frame, {m_layer, m_layerBehind}, layer == 0);
      else
        slideUnder(frame, layer == 0);
    }
    if (m_coloured)
      m_under.composite(frame, camera);
    else
      composite(frame, camera);
  }

  std::vector<std::string> warnings() override {
    const std::vector<uint64_t> samples = m_queries.look();
    if (samples.size() < m_most || samples.empty() || samples.back() == 0) return {};
    return {"depth peeling found a layer in each of its " + std::to_string(m_most) +
            " passes: what lies behind is missing (knob layers)"};
  }

 private:
  void createPipelines(const Context& context, CameraPass& camera) {
    std::string folder = m_coloured ? "depth_peeling/coloured" : "depth_peeling";
    if (camera.coplanar()) folder += "/coplanar";
    rhi::GraphicsPipelineDesc peel = camera.translucentPipeline(folder);
    if (m_coloured) peel.targets.push_back({.format = CameraPass::kColorFormat});
    peel.depth = {.test = true, .write = !camera.byLayer(), .compare = CameraPass::kNearerOrEqual};
    m_peel = forEachLayer(context, peel);
    if (camera.byLayer()) {
      rhi::GraphicsPipelineDesc depth = camera.unshadedPipeline(
          camera.coplanar() ? "depth_peeling/depth_coplanar.frag" : "depth_peeling/depth.frag");
      depth.depth = {.test = true, .write = true, .compare = CameraPass::kNearerOrEqual};
      depth.depthFormat = camera.depthFormat();
      m_peelDepth = forEachLayer(context, depth);
    }
    if (m_coloured) {
      m_under = ColouredLayers(context, camera);
      return;
    }
    rhi::GraphicsPipelineDesc under = camera.compositePipeline("depth_peeling/under.frag");
    under.targets.front().blend = {.enabled = true,
                                   .srcColor = rhi::BlendFactor::DstAlpha,
                                   .dstColor = rhi::BlendFactor::One,
                                   .srcAlpha = rhi::BlendFactor::Zero,
                                   .dstAlpha = rhi::BlendFactor::OneMinusSrcAlpha};
    m_slideUnder = context.pipeline(under);
    m_composite = context.pipeline(camera.compositePipeline("depth_peeling/composite.frag"));
  }

  /// For the first layer and for those behind it.
  struct LayerPipelines {
    rhi::PipelineId first, next;
    rhi::PipelineId of(uint32_t layer) const { return layer == 0 ? first : next; }
  };
  static LayerPipelines forEachLayer(const Context& context, rhi::GraphicsPipelineDesc desc) {
    LayerPipelines pipelines;
    desc.constants.push_back({32, 0});
    pipelines.next = context.pipeline(desc);
    desc.constants.back().bits = 1;
    pipelines.first = context.pipeline(desc);
    return pipelines;
  }

  void createTargets(const Context& context, const CameraPass& camera) {
    const auto ofLayer = [&](const char* label) {
      return context.transients.texture(screenTarget(context, label, CameraPass::kColorFormat),
                                        FramePart::Surfaces);
    };
    for (rhi::Texture& depth : m_depth)
      depth = context.device.createTexture(
          screenTarget(context, "peeled depth", camera.depthFormat(),
                       rhi::TextureUse::DepthTarget | rhi::TextureUse::Sampled));
    m_layer = ofLayer("peeled layer");
    if (m_coloured)
      m_layerBehind = ofLayer("peeled layer's weights");
    else
      m_layers = context.device.createTexture(
          screenTarget(context, "peeled layers", CameraPass::kColorFormat));
    m_sampler =
        context.device.createSampler({.label = "peeling sampler", .filter = rhi::Filter::Nearest});
  }

  /// One more than the last frame (of this step) had layers: the empty one proves that none is
  /// left. All when that is not known, or when there was something in the last one.
  uint32_t layersToPeel(uint32_t step) {
    if (!m_byQuery) return m_most;
    const std::vector<uint64_t> samples = m_atSteps.next(m_queries.take(), step);
    const auto empty = std::ranges::find(samples, 0u);
    return empty == samples.end() ? m_most : uint32_t(empty - samples.begin()) + 1;
  }

  /// Of the opaque surface and of the layer before.
  std::vector<rhi::ResourceUse> depthReads(const CameraPass& camera, uint32_t layer) const {
    std::vector<rhi::ResourceUse> reads = {rhi::use(camera.depth(), rhi::Access::Sampled)};
    if (layer > 0) reads.push_back(rhi::use(m_depth[(layer + 1) % 2].id(), rhi::Access::Sampled));
    return reads;
  }

  void drawLayer(rhi::CommandList& commands, CameraPass& camera, uint32_t layer,
                 const LayerPipelines& pipelines) {
    m_behind[layer == 0 ? 0 : 1 + (layer + 1) % 2].draw(commands, pipelines.of(layer),
                                                        camera.translucent());
  }

  /// The draws that find the layer: by them is known whether there is one.
  void find(rhi::CommandList& commands, CameraPass& camera, uint32_t layer,
            const LayerPipelines& pipelines) {
    auto draw = [&] { drawLayer(commands, camera, layer, pipelines); };
    if (m_byQuery)
      m_queries.count(commands, draw);
    else
      draw();
  }

  void drawDepth(Frame& frame, CameraPass& camera, uint32_t layer) {
    const auto reads = depthReads(camera, layer);
    frame.pass({.label = "layer depth",
                .depth = rhi::DepthAttachment{.view = {.texture = m_depth[layer % 2]},
                                              .clearDepth = CameraPass::kFarDepth},
                .reads = reads},
               PassGroup::Shadow,
               [&](rhi::CommandList& commands) { find(commands, camera, layer, m_peelDepth); });
  }

  void peel(Frame& frame, CameraPass& camera, uint32_t layer) {
    const rhi::ColorAttachment colors[] = {
        {.view = {.texture = m_layer}},
        {.view = {.texture = m_layerBehind}, .clear = {1, 1, 1, 1}}};
    rhi::DepthAttachment depth{.view = {.texture = m_depth[layer % 2]},
                               .clearDepth = CameraPass::kFarDepth};
    if (camera.byLayer()) {
      depth.load = rhi::LoadOp::Load;
      depth.readOnly = true;
    }
    const auto reads = depthReads(camera, layer);
    camera.surfacePass(frame,
                       {.label = "peel",
                        .colors = std::span(colors, m_coloured ? 2 : 1),
                        .depth = depth,
                        .reads = reads},
                       [&](rhi::CommandList& commands) {
                         if (camera.byLayer())
                           drawLayer(commands, camera, layer, m_peel);
                         else
                           find(commands, camera, layer, m_peel);
                       });
  }

  void slideUnder(Frame& frame, bool first) {
    const rhi::ColorAttachment color{.view = {.texture = m_layers},
                                     .load = first ? rhi::LoadOp::Clear : rhi::LoadOp::Load,
                                     .clear = {0, 0, 0, 1}};
    const rhi::ResourceUse read = rhi::use(m_layer, rhi::Access::Sampled);
    const rhi::Binding layer = rhi::textureAt(TEXTURE_TRANSPARENCY, m_layer, m_sampler);
    frame.pass({.label = "slide under", .colors = std::span(&color, 1), .reads = {&read, 1}},
               PassGroup::Scene, [&](rhi::CommandList& commands) {
                 drawFullscreen(commands, m_slideUnder, {&layer, 1});
               });
  }

  void composite(Frame& frame, CameraPass& camera) {
    const rhi::Binding layers = rhi::textureAt(TEXTURE_TRANSPARENCY, m_layers, m_sampler);
    const rhi::ResourceUse read = rhi::use(m_layers.id(), rhi::Access::Sampled);
    camera.compositePass(frame, "composite", {&read, 1}, [&](rhi::CommandList& commands) {
      drawFullscreen(commands, m_composite, {&layers, 1});
    });
  }

  uint32_t m_most = 0;
  bool m_byQuery = false;
  bool m_coloured = false;
  PassQueries m_queries;
  PassesAtSteps m_atSteps;
  rhi::Texture m_depth[2], m_layers;
  rhi::TextureId m_layer, m_layerBehind;  ///< of one layer
  ColouredLayers m_under;
  rhi::Sampler m_sampler;
  LayerPipelines m_peel, m_peelDepth;
  rhi::PipelineId m_slideUnder, m_composite;
  std::vector<DrawList> m_behind;  ///< nothing, m_depth[0], m_depth[1]
};

REGISTER_TECHNIQUE(
    TransparencyTechnique, DepthPeeling,
    (TechniqueInfo{.name = "DepthPeeling",
                   .folder = "depth_peeling",
                   .title = "Depth peeling, front to back",
                   .paper = "Everitt 2001",
                   .represents = {Effect::CameraTransparency, Effect::CameraLayers,
                                  Effect::ColouredTransparency},
                   .requires_ = {rhi::Feature::PreciseOcclusion},
                   .requiresFor = {{Effect::ColouredTransparency, rhi::Feature::DualSourceBlend}},
                   .knobs = {{.name = "stop",
                              .help = "peeling ends behind the last layer, or after a fixed count",
                              .fallback = "query",
                              .choices = {"query", "count"}},
                             {.name = "layers",
                              .help = "most layers a pixel (stop=count: always as many)",
                              .fallback = "32",
                              .min = 1,
                              .max = 64,
                              .sweep = {"1", "2", "4", "8"}}},
                   .error = "none up to the number of layers",
                   .breaksIn = {{"camera layers", "what lies behind `layers` of them is lost"}},
                   .handsOutLayers = true}));

}  // namespace
}  // namespace sb
