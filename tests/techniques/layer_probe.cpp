#include "tests/techniques/layer_probe.h"

#include "shaders/common/shared_slots.h"
#include "techniques/render/camera_pass.h"
#include "techniques/render/screen_targets.h"

namespace sb::test {
namespace {

constexpr rhi::Format kFormat = rhi::Format::RGBA32Float;

class LayerProbe final : public ShadowTechnique {
 public:
  explicit LayerProbe(std::optional<uint32_t> chosen) : m_chosen(chosen) {}

  void prepare(const Context& context) override {
    m_frame = context.view.bindings();
    m_answer = context.device.createTexture(screenTarget(context, "layer probe", kFormat));
    m_sampler =
        context.device.createSampler({.label = "layer probe", .filter = rhi::Filter::Nearest});
    m_pipeline = context.pipeline(
        {.label = "layer probe",
         .vertex = &context.shaders.get("common/fullscreen.vert"),
         .fragment = &context.shaders.get(m_chosen ? "layer_probe/chosen.frag"
                                                   : "layer_probe/position.frag"),
         .targets = {{.format = kFormat}}});
  }

  void record(Frame&) override {}

  void recordReceivers(Frame& frame, const ReceiverLayer& layer) override {
    const rhi::ColorAttachment color{.view = {.texture = m_answer}, .clear = {0, 0, 0, 0}};
    const rhi::ResourceUse read = rhi::use(layer.depth, rhi::Access::Sampled);
    std::vector<rhi::Binding> bindings = m_frame;
    bindings.push_back(rhi::textureAt(TEXTURE_TECHNIQUE + 1, layer.depth, m_sampler));
    frame.pass({.label = "answer " + std::to_string(layer.index),
                .colors = std::span(&color, 1),
                .reads = {&read, 1}},
               PassGroup::Shadow, [&](rhi::CommandList& commands) {
                 if (!m_chosen || *m_chosen == layer.index)
                   drawFullscreen(commands, m_pipeline, bindings);
               });
  }

  VisibilityInputs inputs() const override {
    return {.bindings = {rhi::textureAt(TEXTURE_TECHNIQUE, m_answer, m_sampler)},
            .reads = {rhi::use(m_answer.id(), rhi::Access::Sampled)},
            .constants = {}};
  }

 private:
  std::optional<uint32_t> m_chosen;
  std::vector<rhi::Binding> m_frame;
  rhi::Texture m_answer;
  rhi::Sampler m_sampler;
  rhi::PipelineId m_pipeline;
};

class DirectProbe final : public ShadowTechnique {
  void prepare(const Context&) override {}
  void record(Frame&) override {}
  VisibilityInputs inputs() const override { return {}; }
};

constexpr EffectSet kAll =
    kShadingEffects |
    EffectSet{Effect::OpaqueCasters, Effect::TranslucentCasters, Effect::TranslucentReceivers};

ShadowEntry layerProbe(std::optional<uint32_t> chosen) {
  return {
      {.name = "LayerProbe", .folder = "layer_probe", .represents = kAll, .receiversByLayer = true},
      [chosen] { return std::make_unique<LayerProbe>(chosen); }};
}

}  // namespace

ShadowEntry positionProbe() { return layerProbe({}); }
ShadowEntry chosenLayerProbe(uint32_t layer) { return layerProbe(layer); }
ShadowEntry directProbe() {
  return {{.name = "DirectProbe", .folder = "direct_probe", .represents = kAll},
          [] { return std::make_unique<DirectProbe>(); }};
}

}  // namespace sb::test
