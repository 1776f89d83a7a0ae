// Translucent shadows (Filion and McNaughton 2008, StarCraft II); spec 02. Three passes a light:
// opaque depth, depth of the nearest translucent caster, and the colour that light keeps behind all
// of them. Two depth fetches and a colour a tap. Exact for opaque receivers and for the first
// translucent surface, up to texels; surfaces between get the colour of all layers, those behind
// and themselves included. No noise.
//   variant=energy        D <- D (1 - alpha (1 - t)): what passes; commutes, nothing is sorted
//   variant=published     D <- alpha c + (1 - alpha) D: surface colour as transmission; sorted
//   variant=seed-blend    D <- alpha (1 - alpha) t + (1 - alpha) D: Modisett's program; sorted
//   variant=seed-product  D <- D (1 - alpha) t: the other reading of Modisett's equation
#include <algorithm>

#include "shaders/common/shared_slots.h"
#include "techniques/maps/opaque_casters.h"
#include "techniques/maps/translucent_maps.h"
#include "techniques/partition/light_order.h"
#include "techniques/render/registry.h"

namespace sb {
namespace {

/// Numbers as in shaders/translucent_shadows/colour.frag.glsl.
const std::vector<std::string> kVariants = {"energy", "published", "seed-blend", "seed-product"};

class TranslucentShadows final : public ShadowTechnique {
 public:
  void prepare(const Context& context) override {
    m_maps.emplace(context, 0.0f);
    m_translucent = context.plan.runs(Effect::TranslucentCasters);
    m_constants = m_maps->constants(context.knobs);
    m_constants.push_back({19, m_translucent});
    m_opaque.emplace(context, *m_maps);
    if (m_translucent) createTranslucent(context);
  }

  void moved(Frame& frame) override {
    for (LightOrder& order : m_order) order.sort(frame.commands());
  }

  void record(Frame& frame) override {
    for (size_t i = 0; i < m_maps->views().size(); ++i)
      if (m_maps->views()[i].layer >= 0) recordView(frame, i);
  }

  VisibilityInputs inputs() const override {
    const rhi::Texture& opaque = m_maps->depth();
    VisibilityInputs inputs{.bindings = {}, .reads = {}, .constants = m_constants};
    const rhi::TextureId maps[] = {opaque, m_translucent ? m_depth.id() : opaque.id(),
                                   m_translucent ? m_colour.id() : opaque.id()};
    for (uint32_t i = 0; i < 3; ++i) {
      inputs.bindings.push_back(
          rhi::textureAt(TEXTURE_TECHNIQUE + i, maps[i], m_maps->pointSampler()));
      if (i == 0 || m_translucent) inputs.reads.push_back(rhi::use(maps[i], rhi::Access::Sampled));
    }
    return inputs;
  }

  std::vector<std::pair<std::string, rhi::TextureId>> maps() const override {
    std::vector<std::pair<std::string, rhi::TextureId>> list = {{"depth", m_maps->depth()}};
    if (m_translucent) {
      list.emplace_back("translucent depth", m_depth);
      list.emplace_back("colours", m_colour);
    }
    return list;
  }

  LookupReach reach(uint32_t light) const override { return m_maps->reach(light); }

 private:
  void createTranslucent(const Context& context) {
    const uint32_t variant =
        uint32_t(std::ranges::find(kVariants, context.knobs.text("variant")) - kVariants.begin());
    m_colourFormat = colourMapFormat(context.knobs);
    m_depth = m_maps->createLike(context, "translucent depth", m_maps->depthFormat());
    m_colour = m_maps->createLike(context, "shadow colour", m_colourFormat);
    m_depthPipeline =
        m_maps->pipelines(context, m_maps->casterPipeline(context, "translucent depth",
                                                          "translucent_shadows/depth.frag", false));
    rhi::GraphicsPipelineDesc desc =
        colourPipeline(context, *m_maps, "translucent_shadows/colour.frag", m_colourFormat);
    if (variant == 1 || variant == 2) {
      desc.targets.front().blend = {.enabled = true,
                                    .srcColor = rhi::BlendFactor::SrcAlpha,
                                    .dstColor = rhi::BlendFactor::OneMinusSrcAlpha,
                                    .srcAlpha = rhi::BlendFactor::Zero,
                                    .dstAlpha = rhi::BlendFactor::One};
      m_order = lightOrder(context, *m_maps, context.knobs.text("order"));
    }
    desc.constants.push_back({16, variant});
    m_colourPipeline = context.pipeline(desc);
  }

  void recordView(Frame& frame, size_t i) {
    const LightView& view = m_maps->views()[i];
    rhi::DepthAttachment depth = m_maps->depthAttachment(view);
    frame.pass({.label = "shadow map", .depth = depth}, PassGroup::Shadow,
               [&](rhi::CommandList& commands) { m_opaque->draw(commands, i); });
    if (!m_translucent) return;
    depth.view.texture = m_depth;
    frame.pass({.label = "translucent depth", .depth = depth}, PassGroup::Shadow,
               [&](rhi::CommandList& commands) {
                 m_maps->surfaces(i).draw(commands, m_depthPipeline, view.translucent);
               });
    recordColourPass(frame, *m_maps, view, m_colour, uint32_t(view.layer),
                     [&](rhi::CommandList& commands) {
                       if (m_order.empty())
                         m_maps->surfaces(i).draw(commands, m_colourPipeline, view.translucent);
                       else
                         m_order[i].draw(commands, m_maps->surfaces(i), m_colourPipeline);
                     });
  }

  std::optional<ShadowMaps> m_maps;
  bool m_translucent = false;
  rhi::Format m_colourFormat = rhi::Format::Undefined;
  rhi::Texture m_depth, m_colour;
  std::optional<OpaqueCasters> m_opaque;
  CasterPipelines m_depthPipeline;
  rhi::PipelineId m_colourPipeline;
  std::vector<LightOrder> m_order;  ///< of each view, where order matters
  std::vector<rhi::SpecConstant> m_constants;
};

std::vector<KnobInfo> knobs() {
  std::vector<KnobInfo> list = shadowMapKnobs("1");
  list.push_back(colourFormatKnob());
  list.push_back({.name = "variant",
                  .help = "what a translucent surface does to light: the energy that passes, the "
                          "published blend, or one of two readings of Modisett 2023",
                  .fallback = "energy",
                  .choices = kVariants,
                  .sweep = kVariants});
  list.push_back(lightOrderKnob());
  return list;
}

/// Where the variants that are no product of tau = 1 - alpha (1 - t) differ from the truth (spec
/// 02).
std::map<std::string, std::string> otherLaws() {
  std::map<std::string, std::string> breaks;
  for (const std::string& variant : kVariants)
    if (variant != "energy")
      for (const char* id : {"G10", "layers", "alpha", "coplanar", "between", "cycle", "crossing",
                             "closed", "batch trap", "H7"})
        breaks[id + (" variant:" + variant)] =
            "this variant has another law of transmission than 1 - alpha (1 - t)";
  return breaks;
}

REGISTER_TECHNIQUE(
    ShadowTechnique, TranslucentShadows,
    (TechniqueInfo{
        .name = "TranslucentShadows",
        .folder = "translucent_shadows",
        .title = "Translucent shadows: opaque depth, translucent depth, colour",
        .paper = "Filion, McNaughton 2008",
        .represents = kShadingEffects |
                      EffectSet{Effect::OpaqueCasters, Effect::PerforatedCasters,
                                Effect::TranslucentCasters, Effect::ColouredTransmission,
                                Effect::TexturedTransmission, Effect::TranslucentReceivers},
        .knobs = knobs(),
        .error = "translucent receivers behind the first layer get the colour of all "
                 "layers, those behind and their own included",
        .breaksIn = otherLaws()}));

}  // namespace
}  // namespace sb
