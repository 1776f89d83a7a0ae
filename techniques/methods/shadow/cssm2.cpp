// Coloured stochastic shadow maps, CSSM2 (McGuire and Enderton, I3D 2011); spec 04. One pass a
// light: opaque depth into the depth map and into three colour channels, then translucent casters
// by MAX blending (depth is reversed: the nearest remains), each channel kept with probability
// p = alpha (1 - t). N x N x 3 comparisons a receiver. Right in expectation at every receiver;
// noise falls as 1/N, the filter blurs by N texels.
//   msaa=4           every sample of a texel is an experiment: half the noise, shaded once a sample
//   filter=adaptive  3 x 3, and N x N where these disagree: biased by
//                    (1 - 9/N^2) (q^9 (1 - q) - (1 - q)^9 q) where all channels draw alike
#include "shaders/common/shared_slots.h"
#include "techniques/maps/noise.h"
#include "techniques/maps/shadow_maps.h"
#include "techniques/render/registry.h"

namespace sb {
namespace {

rhi::Format colourFormat(const Knobs& knobs) {
  if (knobs.is("format", "rgba16")) return rhi::Format::RGBA16Unorm;
  if (knobs.is("format", "rgb10a2")) return rhi::Format::RGB10A2Unorm;
  return rhi::Format::RGBA32Float;
}

class ColouredStochasticShadowMap final : public ShadowTechnique {
 public:
  void prepare(const Context& context) override {
    m_coloured = context.plan.runs(Effect::TranslucentCasters);
    m_samples = context.knobs.integer("msaa");
    const bool adaptive = context.knobs.is("filter", "adaptive");
    if (adaptive && m_samples > 1)
      throw rhi::Error("CSSM2", "", "the adaptive filter reads maps of one sample a texel");
    m_colourFormat = colourFormat(context.knobs);
    m_maps.emplace(context, m_coloured ? depthStep(m_colourFormat) : 0.0f,
                   DepthShape{.samples = m_samples});
    if (m_coloured) {
      createColours(context);
      m_noise.emplace(context);
      m_maps->bind(m_noise->binding());
    }
    createPipelines(context);
    m_constants = m_maps->constants(context.knobs);
    m_constants.push_back({19, m_coloured});
    m_constants.push_back({21, m_samples});
    m_constants.push_back({22, adaptive});
    const uint32_t kernel = context.knobs.integer("kernel");
    const bool equal = m_coloured && !adaptive && context.knobs.is("shape", "box");
    m_trials = equal && m_noise->independent() ? kernel * kernel * m_samples : 0;
  }

  void record(Frame& frame) override {
    for (size_t i = 0; i < m_maps->views().size(); ++i)
      if (m_maps->views()[i].layer >= 0) recordView(frame, i);
  }

  VisibilityInputs inputs() const override {
    const rhi::Texture& depth = m_maps->depth();
    // Depth alone when there are no channels; the channels alone when there are (they hold it too).
    const rhi::Texture& read = m_coloured ? m_colours : depth;
    VisibilityInputs inputs{.bindings = {}, .reads = {}, .constants = m_constants};
    if (m_samples > 1) {
      inputs.bindings = {rhi::textureAt(TEXTURE_TECHNIQUE, read, m_maps->pointSampler())};
      inputs.folder = "cssm2_samples";
    } else {
      inputs.bindings = {rhi::textureAt(TEXTURE_TECHNIQUE, depth, m_maps->pointSampler()),
                         rhi::textureAt(TEXTURE_TECHNIQUE + 1, read, m_maps->pointSampler())};
    }
    inputs.reads = {rhi::use(read.id(), rhi::Access::Sampled)};
    if (m_coloured) inputs.reads.push_back(rhi::use(depth.id(), rhi::Access::Sampled));
    return inputs;
  }

  std::vector<std::pair<std::string, rhi::TextureId>> maps() const override {
    if (m_samples > 1) return {};  // samples cannot be read back one by one
    std::vector<std::pair<std::string, rhi::TextureId>> list = {{"depth", m_maps->depth()}};
    if (m_coloured) list.emplace_back("colours", m_colours);
    return list;
  }

  LookupReach reach(uint32_t light) const override {
    LookupReach reach = m_maps->reach(light);
    reach.trials = m_trials;
    return reach;
  }

 private:
  void createColours(const Context& context) {
    const rhi::FormatCaps caps = context.device.formatCaps(m_colourFormat);
    if (!caps.colorTarget || !caps.blend)
      throw rhi::Error("CSSM2", "",
                       std::string("the device cannot blend into ") +
                           std::string(rhi::formatInfo(m_colourFormat).name));
    if (std::ranges::count(caps.sampleCounts, m_samples) == 0 ||
        (m_samples > 1 && !context.device.supports(rhi::Feature::SampleRateShading)))
      throw rhi::Error("CSSM2", "",
                       "the device does not shade " + std::to_string(m_samples) + " samples of " +
                           std::string(rhi::formatInfo(m_colourFormat).name));
    m_colours = context.device.createTexture({.label = "shadow map colours",
                                              .kind = rhi::TextureKind::Tex2DArray,
                                              .format = m_colourFormat,
                                              .width = m_maps->size(),
                                              .height = m_maps->size(),
                                              .layers = std::max(1u, m_maps->layers()),
                                              .samples = m_samples,
                                              .use = rhi::TextureUse::ColorTarget |
                                                     rhi::TextureUse::Sampled |
                                                     rhi::TextureUse::CopySource});
  }

  static void shadeSamples(const Context& context, rhi::GraphicsPipelineDesc& desc) {
    desc.sampleShading = true;
    desc.vertex = &context.shaders.get("common/light_surface_samples.vert");
  }

  void createPipelines(const Context& context) {
    bool opaque = false, perforated = false, translucent = false;
    for (const LightView& view : m_maps->views()) {
      opaque |= !view.opaque.empty();
      perforated |= !view.perforated.empty();
      translucent |= !view.translucent.empty();
    }
    // Each sample has a depth of its own, and the channels hold it.
    const bool everySample = m_coloured && m_samples > 1;
    const char* coloured = everySample ? "cssm2/opaque_samples.frag" : "cssm2/opaque.frag";
    auto caster = [&](const char* label, const char* depthOnly, bool masked) {
      rhi::GraphicsPipelineDesc desc =
          m_maps->casterPipeline(context, label, m_coloured ? coloured : depthOnly, masked);
      if (m_coloured) desc.targets = {{.format = m_colourFormat}};
      desc.samples = m_samples;
      if (everySample) shadeSamples(context, desc);
      return m_maps->pipelines(context, desc);
    };
    if (opaque) m_opaque = caster("cssm2 opaque", "", false);
    if (perforated) m_perforated = caster("cssm2 perforated", "common/masked.frag", true);
    if (!m_coloured || !translucent) return;
    rhi::GraphicsPipelineDesc desc = m_maps->casterPipeline(
        context, "cssm2 translucent",
        m_samples > 1 ? "cssm2/samples.frag" : "cssm2/translucent.frag", false);
    desc.samples = m_samples;
    if (everySample) shadeSamples(context, desc);
    // The nearest translucent layer must not hide the others: depth is tested, never written.
    desc.depth.write = false;
    desc.targets = {{.format = m_colourFormat,
                     .blend = {.enabled = true,
                               .dstColor = rhi::BlendFactor::One,
                               .colorOp = rhi::BlendOp::Max,
                               .dstAlpha = rhi::BlendFactor::One,
                               .alphaOp = rhi::BlendOp::Max}}};
    desc.constants.push_back({16, context.knobs.is("numbers", "shared")});
    desc.constants.insert(desc.constants.end(), m_noise->constants().begin(),
                          m_noise->constants().end());
    m_translucent = m_maps->pipelines(context, desc);
  }

  void recordView(Frame& frame, size_t i) {
    const LightView& view = m_maps->views()[i];
    const rhi::DepthAttachment depth = m_maps->depthAttachment(view);
    rhi::ColorAttachment colour{.clear = {0, 0, 0, 1}};
    if (m_coloured) {
      colour.view = depth.view;
      colour.view.texture = m_colours;
    }
    frame.pass(
        {.label = "shadow map", .colors = std::span(&colour, m_coloured ? 1 : 0), .depth = depth},
        PassGroup::Shadow, [&](rhi::CommandList& commands) {
          DrawList& plain = m_coloured ? m_maps->surfaces(i) : m_maps->plain(i);
          plain.draw(commands, m_opaque, view.opaque);
          m_maps->surfaces(i).draw(commands, m_perforated, view.perforated);
          if (m_translucent) m_maps->surfaces(i).draw(commands, *m_translucent, view.translucent);
        });
  }

  std::optional<ShadowMaps> m_maps;
  std::optional<Noise> m_noise;
  bool m_coloured = false;
  uint32_t m_samples = 1;
  uint32_t m_trials = 0;  ///< texels that a lookup averages with equal weights
  rhi::Format m_colourFormat = rhi::Format::Undefined;
  rhi::Texture m_colours;
  CasterPipelines m_opaque, m_perforated;
  std::optional<CasterPipelines> m_translucent;
  std::vector<rhi::SpecConstant> m_constants;
};

std::vector<KnobInfo> knobs() {
  std::vector<KnobInfo> list = shadowMapKnobs("9");
  list.push_back({.name = "format",
                  .help = "of the three depths of a texel",
                  .fallback = "rgba32f",
                  .choices = {"rgb10a2", "rgba16", "rgba32f"},
                  .sweep = {"rgb10a2", "rgba16", "rgba32f"}});
  list.push_back(channelNumbersKnob());
  list.push_back(noiseKnob());
  list.push_back(mapSamplesKnob());
  list.push_back({.name = "filter",
                  .help = "the whole kernel everywhere, or only where 3x3 texels disagree",
                  .fallback = "full",
                  .choices = {"full", "adaptive"},
                  .sweep = {"adaptive", "full"}});
  return list;
}

REGISTER_TECHNIQUE(
    ShadowTechnique, ColouredStochasticShadowMap,
    (TechniqueInfo{
        .name = "CSSM2",
        .folder = "cssm2",
        .title = "Coloured stochastic shadow maps, three depths a texel",
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
