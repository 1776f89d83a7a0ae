// Stochastic shadow maps (Enderton, Sintorn, Shirley, Luebke 2010); spec 03. One depth-only pass a
// light: opaque casters, then translucent ones, each texel of which is kept with the probability of
// its opacity. N x N comparisons a receiver. Right in expectation at every receiver, but grey:
// noise falls as 1/N, the filter blurs by N texels.
//   opacity=luminance  alpha (1 - luminance of t): the light that is lost, exact for grey t, and
//   what
//                      coloured techniques are compared with (spec 17, G10); the default
//   opacity=alpha      as published: what passes a surface is neither tinted nor counted
//   msaa=4             each fragment keeps a random subset of the samples, stratified
#include <algorithm>

#include "shaders/common/shared_slots.h"
#include "techniques/maps/depth_compare.h"
#include "techniques/maps/noise.h"
#include "techniques/maps/opaque_casters.h"
#include "techniques/render/registry.h"

namespace sb {
namespace {

class StochasticShadowMap final : public ShadowTechnique {
 public:
  void prepare(const Context& context) override {
    m_samples = context.knobs.integer("msaa");
    m_maps.emplace(context, 0.0f, DepthShape{.samples = m_samples});
    m_compare.emplace(context, *m_maps, m_samples);
    createPipelines(context);
    m_constants = m_maps->constants(context.knobs);
    m_trials = m_noise && m_noise->independent() ? m_compare->equalTexels() : 0;
  }

  void record(Frame& frame) override {
    for (size_t i = 0; i < m_maps->views().size(); ++i) {
      const LightView& view = m_maps->views()[i];
      if (view.layer < 0) continue;
      // Opaque casters first: what they hide is tested away early and could not win (spec 03).
      frame.pass({.label = "shadow map", .depth = m_maps->depthAttachment(view)}, PassGroup::Shadow,
                 [&](rhi::CommandList& commands) {
                   m_opaque->draw(commands, i);
                   if (m_translucent)
                     m_maps->surfaces(i).draw(commands, *m_translucent, view.translucent);
                 });
    }
  }

  VisibilityInputs inputs() const override {
    return m_compare->inputs(*m_maps, m_constants, "stochastic_shadow_map_samples");
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
  void createPipelines(const Context& context) {
    const auto sampled = [&](rhi::GraphicsPipelineDesc& desc) { desc.samples = m_samples; };
    m_opaque.emplace(context, *m_maps, sampled);
    const bool translucent = std::ranges::any_of(
        m_maps->views(), [](const LightView& view) { return !view.translucent.empty(); });
    if (!context.plan.runs(Effect::TranslucentCasters) || !translucent) return;
    m_noise.emplace(context);
    m_maps->bind(m_noise->binding());
    rhi::GraphicsPipelineDesc desc =
        m_maps->casterPipeline(context, "shadow map translucent",
                               m_samples > 1 ? "stochastic_shadow_map/samples.frag"
                                             : "stochastic_shadow_map/translucent.frag",
                               false);
    sampled(desc);
    desc.constants.push_back({17, context.knobs.is("opacity", "luminance")});
    if (m_samples > 1) desc.constants.push_back({18, m_samples});
    desc.constants.insert(desc.constants.end(), m_noise->constants().begin(),
                          m_noise->constants().end());
    m_translucent = m_maps->pipelines(context, desc);
  }

  std::optional<ShadowMaps> m_maps;
  std::optional<DepthCompare> m_compare;
  std::optional<Noise> m_noise;
  uint32_t m_samples = 1;
  uint32_t m_trials = 0;  ///< texels that a lookup averages with equal weights
  std::optional<OpaqueCasters> m_opaque;
  std::optional<CasterPipelines> m_translucent;
  std::vector<rhi::SpecConstant> m_constants;
};

std::vector<KnobInfo> knobs() {
  std::vector<KnobInfo> list = shadowMapKnobs("9");
  list.push_back({.name = "opacity",
                  .help = "of a translucent caster: the luminance that it takes, or its alpha "
                          "whatever passes through it",
                  .fallback = "luminance",
                  .choices = {"luminance", "alpha"}});
  list.push_back(noiseKnob());
  list.push_back(mapSamplesKnob());
  list.push_back(compareKnob());
  return list;
}

std::map<std::string, std::string> breaks() {
  std::map<std::string, std::string> breaks = sourceNoiseBreaks();
  for (const char* id : {"G10", "H7", "batch trap", "certain", "closed", "crossing", "cycle"})
    breaks[id + std::string(" opacity:alpha")] =
        "opacity=alpha blocks by opacity, whatever passes through the surface";
  return breaks;
}

REGISTER_TECHNIQUE(
    ShadowTechnique, StochasticShadowMap,
    (TechniqueInfo{
        .name = "StochasticShadowMap",
        .folder = "stochastic_shadow_map",
        .title = "Stochastic shadow maps, grey",
        .paper = "Enderton, Sintorn, Shirley, Luebke 2010",
        .represents = kShadingEffects |
                      EffectSet{Effect::OpaqueCasters, Effect::PerforatedCasters,
                                Effect::TranslucentCasters, Effect::TexturedTransmission,
                                Effect::TranslucentReceivers, Effect::TranslucentOverlap},
        .knobs = knobs(),
        .error = "coloured transmission becomes grey; none in expectation otherwise; noise at "
                 "finite kernels, edges blurred by the kernel",
        .stochastic = true,
        .breaksIn = breaks()}));

}  // namespace
}  // namespace sb
