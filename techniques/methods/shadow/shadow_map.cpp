// Shadow mapping (Williams 1978) with percentage-closer filtering (Reeves, Salesin, Cook 1987);
// spec 01. One depth-only pass a light (six for a point light), N x N comparisons a receiver.
// Hard shadows of opaque casters; texel-sized error at edges; no colour, no penumbra.
#include "techniques/maps/depth_compare.h"
#include "techniques/render/registry.h"

namespace sb {
namespace {

class ShadowMap final : public ShadowTechnique {
 public:
  void prepare(const Context& context) override {
    m_maps.emplace(context, 0.0f);
    const bool front = context.knobs.is("cull", "front");
    m_translucentCast = context.knobs.is("translucent", "opaque");
    auto pipeline = [&](const char* label, const char* fragment, bool masked) {
      rhi::GraphicsPipelineDesc desc = m_maps->casterPipeline(context, label, fragment, masked);
      desc.raster.cull = front ? rhi::CullMode::Front : rhi::CullMode::None;
      return m_maps->pipelines(context, desc);
    };
    bool opaque = false, perforated = false;
    for (const LightView& view : m_maps->views()) {
      opaque |= !view.opaque.empty() || (m_translucentCast && !view.translucent.empty());
      perforated |= !view.perforated.empty();
    }
    if (opaque) m_opaque = pipeline("shadow map opaque", "", false);
    if (perforated) m_perforated = pipeline("shadow map perforated", "common/masked.frag", true);
    m_compare.emplace(context, *m_maps);
    m_constants = m_maps->constants(context.knobs);
  }

  void record(Frame& frame) override {
    for (size_t i = 0; i < m_maps->views().size(); ++i) {
      const LightView& view = m_maps->views()[i];
      if (view.layer < 0) continue;
      frame.pass({.label = "shadow map", .depth = m_maps->depthAttachment(view)}, PassGroup::Shadow,
                 [&](rhi::CommandList& commands) {
                   m_maps->plain(i).draw(commands, m_opaque, view.opaque);
                   if (m_translucentCast)
                     m_maps->plain(i).draw(commands, m_opaque, view.translucent);
                   m_maps->surfaces(i).draw(commands, m_perforated, view.perforated);
                 });
    }
  }

  VisibilityInputs inputs() const override { return m_compare->inputs(*m_maps, m_constants); }

  std::vector<std::pair<std::string, rhi::TextureId>> maps() const override {
    return {{"depth", m_maps->depth()}};
  }

  LookupReach reach(uint32_t light) const override { return m_maps->reach(light); }

 private:
  std::optional<ShadowMaps> m_maps;
  CasterPipelines m_opaque, m_perforated;
  std::optional<DepthCompare> m_compare;
  bool m_translucentCast = false;
  std::vector<rhi::SpecConstant> m_constants;
};

std::vector<KnobInfo> knobs() {
  std::vector<KnobInfo> list = shadowMapKnobs("1");
  list.push_back(compareKnob());
  list.push_back({.name = "cull",
                  .help = "faces left out of the map: none, or front faces of closed casters",
                  .fallback = "none",
                  .choices = {"none", "front"}});
  list.push_back({.name = "translucent",
                  .help = "translucent casters cast no shadow, or a full one",
                  .fallback = "none",
                  .choices = {"none", "opaque"}});
  return list;
}

constexpr const char* kSlopes = "one bias for all slopes is too small for steep ones";

REGISTER_TECHNIQUE(
    ShadowTechnique, ShadowMap,
    (TechniqueInfo{
        .name = "ShadowMap",
        .folder = "shadow_map",
        .title = "Shadow mapping with percentage-closer filtering",
        .paper = "Williams 1978; Reeves, Salesin, Cook 1987",
        .represents = kShadingEffects | EffectSet{Effect::OpaqueCasters, Effect::PerforatedCasters},
        .knobs = knobs(),
        .error = "translucent casters cast all or nothing; edges move by half a texel; "
                 "the filter blurs, it makes no penumbra",
        .breaksIn = {{"G11 bias:constant", kSlopes},
                     {"H3 bias:constant", kSlopes},
                     {"sheet bias:constant", kSlopes}}}));

}  // namespace
}  // namespace sb
