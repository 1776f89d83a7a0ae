// Coloured stochastic shadow maps, CSSM1 (McGuire and Enderton, I3D 2011); spec 04. A stochastic
// depth map for each of three channels, layers of one array: every caster is drawn into all of them
// in one pass, a translucent one kept in each with probability p = alpha (1 - t). N x N comparisons
// a channel, which the hardware can do. Right in expectation at every receiver; with the same
// numbers its layers are CSSM2's channels, bit by bit. Noise falls as 1/N, the filter blurs by N
// texels.
//   msaa=4   each fragment keeps a random subset of the samples in each channel, stratified
#include "shaders/common/shared_slots.h"
#include "techniques/maps/depth_compare.h"
#include "techniques/maps/noise.h"
#include "techniques/render/registry.h"

namespace sb {
namespace {

constexpr uint32_t kChannels = 3;

class LayeredStochasticShadowMap final : public ShadowTechnique {
 public:
  void prepare(const Context& context) override {
    m_coloured = context.plan.runs(Effect::TranslucentCasters);
    m_samples = context.knobs.integer("msaa");
    m_maps.emplace(context, 0.0f,
                   DepthShape{.layersPerView = m_coloured ? kChannels : 1, .samples = m_samples});
    m_compare.emplace(context, *m_maps, m_samples);
    // A geometry shader makes the copies where a vertex shader cannot pick the layer.
    m_geometry = context.knobs.is("layered", "geometry") ||
                 !context.device.supports(rhi::Feature::VertexLayer);
    m_copies = m_coloured && !m_geometry ? kChannels : 1;
    context.view.copyInstances(context.device, m_copies);
    if (m_coloured) {
      m_noise.emplace(context);
      m_maps->bind(m_noise->binding());
    }
    createPipelines(context);
    m_constants = m_maps->constants(context.knobs);
    m_constants.push_back({22, m_coloured});
    m_trials = m_noise && m_noise->independent() ? m_compare->equalTexels() : 0;
  }

  void record(Frame& frame) override {
    for (size_t i = 0; i < m_maps->views().size(); ++i) {
      const LightView& view = m_maps->views()[i];
      if (view.layer < 0) continue;
      frame.pass({.label = "shadow map", .depth = m_maps->depthAttachment(view)}, PassGroup::Shadow,
                 [&](rhi::CommandList& commands) {
                   m_maps->plain(i).draw(commands, m_opaque, view.opaque, m_copies);
                   m_maps->surfaces(i).draw(commands, m_perforated, view.perforated, m_copies);
                   if (m_translucent)
                     m_maps->surfaces(i).draw(commands, *m_translucent, view.translucent, m_copies);
                 });
    }
  }

  VisibilityInputs inputs() const override {
    return m_compare->inputs(*m_maps, m_constants, "cssm1_samples");
  }

  std::vector<std::pair<std::string, rhi::TextureId>> maps() const override {
    if (m_samples > 1) return {};  // samples cannot be read back one by one
    return {{"depth", m_maps->depth()}};
  }

  LookupReach reach(uint32_t light) const override {
    LookupReach reach = m_maps->reach(light);
    reach.trials = m_trials;
    return reach;
  }

 private:
  /// Of casters, into all channels' layers.
  rhi::GraphicsPipelineDesc casters(const Context& context, const char* label,
                                    const std::string& fragment, bool masked) const {
    rhi::GraphicsPipelineDesc desc = m_maps->casterPipeline(context, label, fragment, masked);
    desc.samples = m_samples;
    const std::string pass = fragment.empty() ? "cssm1/opaque" : "cssm1/surface";
    if (m_coloured && m_geometry) desc.geometry = &context.shaders.get(pass + ".geom");
    if (m_coloured && !m_geometry) desc.vertex = &context.shaders.get(pass + ".vert");
    return desc;
  }

  void createPipelines(const Context& context) {
    bool opaque = false, perforated = false, translucent = false;
    for (const LightView& view : m_maps->views()) {
      opaque |= !view.opaque.empty();
      perforated |= !view.perforated.empty();
      translucent |= !view.translucent.empty();
    }
    if (opaque)
      m_opaque = m_maps->pipelines(context, casters(context, "shadow map opaque", "", false));
    if (perforated)
      m_perforated = m_maps->pipelines(
          context, casters(context, "shadow map perforated", "common/masked.frag", true));
    if (!m_coloured || !translucent) return;
    rhi::GraphicsPipelineDesc desc =
        casters(context, "shadow map translucent",
                m_samples > 1 ? "cssm1/samples.frag" : "cssm1/translucent.frag", false);
    if (m_samples > 1) desc.constants.push_back({18, m_samples});
    desc.constants.push_back({16, context.knobs.is("numbers", "shared")});
    desc.constants.insert(desc.constants.end(), m_noise->constants().begin(),
                          m_noise->constants().end());
    m_translucent = m_maps->pipelines(context, desc);
  }

  std::optional<ShadowMaps> m_maps;
  std::optional<DepthCompare> m_compare;
  std::optional<Noise> m_noise;
  bool m_coloured = false;
  bool m_geometry = false;
  uint32_t m_samples = 1;
  uint32_t m_copies = 1;  ///< of each caster that a draw makes
  uint32_t m_trials = 0;  ///< texels that a lookup averages with equal weights
  CasterPipelines m_opaque, m_perforated;
  std::optional<CasterPipelines> m_translucent;
  std::vector<rhi::SpecConstant> m_constants;
};

std::vector<KnobInfo> knobs() {
  std::vector<KnobInfo> list = shadowMapKnobs("9");
  list.push_back(channelNumbersKnob());
  list.push_back(noiseKnob());
  list.push_back(mapSamplesKnob());
  list.push_back(compareKnob());
  list.push_back({.name = "layered",
                  .help = "what sends casters to the layers: the vertex shader of three instances "
                          "(where the device can), or a geometry shader",
                  .fallback = "vertex",
                  .choices = {"vertex", "geometry"},
                  .sweep = {"vertex", "geometry"}});
  return list;
}

REGISTER_TECHNIQUE(
    ShadowTechnique, LayeredStochasticShadowMap,
    (TechniqueInfo{
        .name = "CSSM1",
        .folder = "cssm1",
        .title = "Coloured stochastic shadow maps, a depth map a channel",
        .paper = "McGuire, Enderton 2011",
        .represents = kShadingEffects |
                      EffectSet{Effect::OpaqueCasters, Effect::PerforatedCasters,
                                Effect::TranslucentCasters, Effect::ColouredTransmission,
                                Effect::TexturedTransmission, Effect::TranslucentReceivers,
                                Effect::TranslucentOverlap},
        .knobs = knobs(),
        .error = "none in expectation; noise at finite kernels, edges blurred by the kernel",
        .stochastic = true,
        .breaksIn = sourceNoiseBreaks()}));

}  // namespace
}  // namespace sb
