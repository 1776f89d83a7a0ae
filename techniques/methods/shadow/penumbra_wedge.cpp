// Soft shadow volumes with penumbra wedges (Akenine-Moller and Assarsson 2002; Assarsson and
// Akenine-Moller 2003; Assarsson, Dougherty, Mounier and Akenine-Moller 2003); spec 08. For each
// layer of receivers and each light with an extent: the volumes of the light's centre are counted
// at the receiver, and where a silhouette's edge may lie before the light, within its wedge, the
// share of the light that it uncovers is added. Two passes a light; fill over wedges and volumes.
// Lights without extent, and penumbrae narrower than a pixel, are those of StencilShadowVolume.
//   combine=shader  (default) sums of all wedges, in one draw; where the count of volumes may have
//                   the centre on the other side of an edge than its share, within a pixel of hard
//                   edges, each caster anew from its own edges and triangles
//   combine=float   sums alone: wrong by 1 at some of these pixels
//   combine=wrap    caster by caster: a share beyond [0, 1] is wrong by 1
//   combine=exact   no sums: each caster's edges and triangles at every pixel
//   coverage=lut    the source's tables in place of the closed form
//   format=rgba8    the source's buffer: shares in steps of 1/32, of which eight may overlap
// Casters that overlap before the light, and layers of one mesh that do, hide it twice; silhouettes
// are those of the light's centre; shares are of the disc, whatever the receiver's horizon.
#include <bit>

#include "shaders/common/shared_slots.h"
#include "techniques/render/camera_pass.h"
#include "techniques/render/registry.h"
#include "techniques/render/screen_targets.h"
#include "techniques/scene/light_area.h"
#include "techniques/volumes/coverage_tables.h"
#include "techniques/volumes/hard_shadows.h"
#include "techniques/volumes/light_wedges.h"

namespace sb {
namespace {

using Volumes = std::vector<const LightVolumes*>;

class PenumbraWedge final : public ShadowTechnique {
 public:
  void prepare(const Context& context) override {
    m_context.emplace(context);
    m_wedges.emplace(context);
    m_exact = context.knobs.is("combine", "exact");
    m_wrap = context.knobs.is("combine", "wrap");
    uint32_t mostLights = 0, mostInView = 0;
    std::vector<LightVolumes> hard, soft;
    const auto visit = [&](const std::vector<LightVolumes>& lights) {
      mostLights = std::max(mostLights, uint32_t(lights.size()));
      mostInView = std::max(mostInView, uint32_t(maskSlots(context.view, lights).size()));
      const Volumes softNow = softOf(lights);
      m_wedges->reserve(softNow);
      for (const LightVolumes* light : softNow) soft.push_back(*light);
      // Another eye may see a penumbra as a hard edge.
      for (const LightVolumes& light : lights)
        if (context.view.isFree() || !isSoft(light)) hard.push_back(light);
    };
    const CullingChoice culling{.extents = context.plan.runs(Effect::AreaLights)};
    m_volumes.emplace(context, VolumeBuilder::Cpu, VolumeChoice{}, culling, visit);
    if (mostLights == 0) return;
    m_mask.emplace(context, soft.empty() ? MaskKind::Binary : MaskKind::Share, mostLights,
                   mostInView);
    m_hard.emplace(context, CounterKind::Stencil, VolumeFaces::Both);
    m_hard->prepare(*m_volumes, hard, *m_mask);
    if (!soft.empty()) prepareSoft(soft);
    if (context.view.steps() > 1) return;  // each frame writes its own
    update([&](rhi::BufferId buffer, std::span<const std::byte> bytes) {
      context.device.upload(buffer, 0, bytes);
    });
  }

  void moved(Frame& frame) override {
    m_volumes->moved(frame);
    if (!m_mask) return;
    update([&](rhi::BufferId buffer, std::span<const std::byte> bytes) {
      frame.commands().write(buffer, 0, bytes);
    });
  }

  void record(Frame& frame) override { m_volumes->record(frame); }

  void recordReceivers(Frame& frame, const ReceiverLayer& layer) override {
    const std::vector<LightVolumes>& lights = m_volumes->lights();
    size_t soft = 0;
    for (uint32_t slot = 0; slot < lights.size(); ++slot) {
      if (!isSoft(lights[slot]))
        m_hard->record(frame, layer, *m_volumes, std::span(lights).subspan(slot, 1), *m_mask, slot);
      else
        recordSoft(frame, layer, slot, soft++);
    }
  }

  VisibilityInputs inputs() const override {
    // Translucent casters alone throw no shadow here.
    if (!m_mask)
      return {
          .bindings = {}, .reads = {}, .constants = {}, .folder = baselineTechnique().info.folder};
    return m_mask->inputs();
  }

  std::vector<std::pair<std::string, uint64_t>> counts() const override {
    auto counts = m_volumes->counts();
    counts.emplace_back("penumbra wedges", m_wedges->count());
    // Not shown to hold their penumbra.
    counts.emplace_back("penumbra wedges drawn everywhere", m_wedges->everywhere());
    return counts;
  }

 private:
  /// Its penumbrae may be a pixel wide.
  bool isSoft(const LightVolumes& light) const {
    const SceneView& view = m_context->view;
    return m_context->plan.runs(Effect::AreaLights) &&
           isAreaLight(view.placed().light(light.light)) &&
           view.effects().lights[light.light].penumbra * view.size().height >= 1;
  }
  Volumes softOf(const std::vector<LightVolumes>& lights) const {
    Volumes soft;
    for (const LightVolumes& light : lights)
      if (isSoft(light)) soft.push_back(&light);
    return soft;
  }

  void update(const ShadowMask::Write& write) {
    m_mask->assign(maskSlots(m_context->view, m_volumes->lights()), write);
    if (m_sampler) m_wedges->find(*m_volumes, softOf(m_volumes->lights()), write);
  }

  void prepareSoft(const std::vector<LightVolumes>& lights) {
    const Context& context = *m_context;
    const bool bytes = context.knobs.is("format", "rgba8");
    const rhi::Format format = bytes                                ? rhi::Format::RGBA8Unorm
                               : context.knobs.is("format", "r16f") ? rhi::Format::RG16Float
                                                                    : rhi::Format::RG32Float;
    const bool tables = context.knobs.is("coverage", "lut");
    if (tables) m_tables = coverageTables(context.device, context.knobs.integer("lut"));
    m_wedges->createBuffers();
    m_sampler =
        context.device.createSampler({.label = "penumbra sampler", .filter = rhi::Filter::Nearest});
    if (!m_exact) {
      m_counter.emplace(context, CounterKind::Float, VolumeFaces::Both, format);
      m_counter->prepare(*m_volumes, lights);
      m_hidden = context.transients.texture(screenTarget(context, "penumbra shares", format),
                                            FramePart::Receivers);
      m_wedgePipeline = context.pipeline(
          {.label = "penumbra wedges",
           .vertex = &context.shaders.get("penumbra_wedge/wedge.vert"),
           .fragment = &context.shaders.get(tables ? "penumbra_wedge/wedge_tables.frag"
                                                   : "penumbra_wedge/wedge.frag"),
           .constants = {{16, bytes}},
           // Backs alone: what lies in a wedge lies before them, wherever the eye is.
           .raster = {.cull = rhi::CullMode::Front, .depthClamp = true},
           .depth = {.test = true, .compare = rhi::CompareOp::LessOrEqual},
           .targets = {{.format = format, .blend = kBlendAdd}},
           .depthFormat = VolumeCounter::kDepthFormat});
    }
    const bool exactly = m_exact || context.knobs.is("combine", "shader");
    const float least = bytes ? 0.5f / 32 : format == rhi::Format::RG16Float ? 1e-3f : 1e-4f;
    for (uint32_t channel = 0; channel < m_mask->channels(); ++channel) {
      rhi::ColorTargetState target = m_mask->target(channel);
      if (m_wrap) {
        target.blend = kBlendAdd;
        target.blend.colorOp = target.blend.alphaOp = rhi::BlendOp::ReverseSubtract;
      }
      m_maskPipelines.push_back(context.pipeline(
          {.label = "penumbra mask",
           .vertex = &context.shaders.get("common/fullscreen.vert"),
           .fragment = &context.shaders.get(tables ? "penumbra_wedge/mask_tables.frag"
                                                   : "penumbra_wedge/mask.frag"),
           .constants = {{16, !m_exact},
                         {17, exactly},
                         {18, m_wrap},
                         {19, std::bit_cast<uint32_t>(least)},
                         {20, bytes}},
           .targets = {target}}));
    }
  }

  /// `soft`: the light among those with penumbrae.
  void recordSoft(Frame& frame, const ReceiverLayer& layer, uint32_t slot, size_t soft) const {
    const LightVolumes& light = m_volumes->lights()[slot];
    if (!m_wrap) {
      if (!m_exact) recordWedges(frame, layer, light, light.casters, soft, m_wedges->ofLight(soft));
      return recordMask(frame, layer, slot, soft, true);
    }
    for (size_t i = 0; i < light.casters.size(); ++i) {
      recordWedges(frame, layer, light, std::span(light.casters).subspan(i, 1), soft,
                   m_wedges->ofCaster(soft, i));
      recordMask(frame, layer, slot, soft, i == 0);
    }
  }

  std::vector<rhi::Binding> bindings(const ReceiverLayer& layer, size_t soft) const {
    std::vector<rhi::Binding> bindings = m_wedges->bindings(soft);
    bindings.push_back(rhi::textureAt(TEXTURE_TECHNIQUE, layer.depth, m_sampler));
    if (m_tables) {
      bindings.push_back(
          rhi::textureAt(TEXTURE_TECHNIQUE + 2, m_tables->oneSide, m_tables->sampler));
      bindings.push_back(
          rhi::textureAt(TEXTURE_TECHNIQUE + 3, m_tables->bothSides, m_tables->sampler));
    }
    return bindings;
  }

  /// `casters`: of the light; `wedges`: theirs.
  void recordWedges(Frame& frame, const ReceiverLayer& layer, const LightVolumes& light,
                    std::span<const CasterVolume> casters, size_t soft,
                    const WedgeRange& wedges) const {
    const rhi::ColorAttachment hidden{.view = {.texture = m_hidden}};
    const rhi::ResourceUse depth = rhi::use(layer.depth, rhi::Access::Sampled);
    frame.pass(
        {.label = "penumbra wedges",
         .colors = std::span(&hidden, 1),
         .depth =
             rhi::DepthAttachment{
                 .view = {.texture = layer.depth}, .load = rhi::LoadOp::Load, .readOnly = true},
         .reads = {&depth, 1}},
        PassGroup::Shadow, [&](rhi::CommandList& commands) {
          m_counter->draw(commands, *m_volumes, light, casters);
          if (wedges.count == 0) return;
          const std::vector<rhi::Binding> all = bindings(layer, soft);
          commands.draw({.pipeline = m_wedgePipeline, .bindings = all, .scissor = light.scissor},
                        {.vertexCount = WEDGE_VERTICES * wedges.count,
                         .firstVertex = WEDGE_VERTICES * wedges.first});
        });
  }

  /// `first`: of what goes into the slot.
  void recordMask(Frame& frame, const ReceiverLayer& layer, uint32_t slot, size_t soft,
                  bool first) const {
    rhi::ColorAttachment target = m_mask->attachment(slot);
    if (!first) target.load = rhi::LoadOp::Load;
    std::vector<rhi::ResourceUse> reads = {rhi::use(layer.depth, rhi::Access::Sampled)};
    if (m_hidden) reads.push_back(rhi::use(m_hidden, rhi::Access::Sampled));
    std::vector<rhi::Binding> all = bindings(layer, soft);
    // Where nothing is summed nothing reads it.
    all.push_back(
        rhi::textureAt(TEXTURE_TECHNIQUE + 1, m_hidden ? m_hidden : layer.depth, m_sampler));
    frame.pass({.label = "shadow mask", .colors = std::span(&target, 1), .reads = reads},
               PassGroup::Shadow, [&](rhi::CommandList& commands) {
                 drawFullscreen(commands, m_maskPipelines[slot % ShadowMask::kChannels], all);
               });
  }

  std::optional<Context> m_context;
  bool m_exact = false, m_wrap = false;
  std::optional<ShadowVolumes> m_volumes;
  std::optional<ShadowMask> m_mask;
  std::optional<HardShadows> m_hard;
  std::optional<LightWedges> m_wedges;
  std::optional<VolumeCounter> m_counter;
  std::optional<CoverageTables> m_tables;
  rhi::TextureId m_hidden{};  ///< red: by volumes and wedges; green: edges that it is unsure about
  rhi::Sampler m_sampler;
  rhi::PipelineId m_wedgePipeline;
  std::vector<rhi::PipelineId> m_maskPipelines;  ///< by channel
};

std::vector<KnobInfo> knobs() {
  return {{.name = "combine",
           .help = "how volumes and wedges are combined: sums, put right by caster near hard edges "
                   "(shader), not at all (float), by their range (wrap); or no sums (exact)",
           .fallback = "shader",
           .choices = {"shader", "float", "wrap", "exact"},
           .sweep = {"float", "wrap", "shader", "exact"}},
          {.name = "coverage",
           .help = "shares of discs in closed form, or from the source's tables",
           .fallback = "closed",
           .choices = {"closed", "lut"},
           .sweep = {"lut", "closed"}},
          {.name = "lut",
           .unit = "nodes",
           .help = "of the source's tables along each of their three axes",
           .fallback = "32",
           .choices = {"16", "32", "64", "128"},
           .sweep = {"16", "32", "64", "128"}},
          {.name = "format",
           .help = "of sums; rgba8: the source's, in steps of 1/32",
           .fallback = "r32f",
           .choices = {"rgba8", "r16f", "r32f"},
           .sweep = {"rgba8", "r16f", "r32f"}}};
}

std::map<std::string, std::string> breaks() {
  return {{"overlaps", "the stencil counts modulo 256: as many layers are none"},
          {"many edges format:rgba8", "bytes have room for the shares of eight edges"}};
}

REGISTER_TECHNIQUE(
    ShadowTechnique, PenumbraWedge,
    (TechniqueInfo{
        .name = "PenumbraWedge",
        .folder = "penumbra_wedge",
        .title = "Soft shadow volumes with penumbra wedges",
        .paper = "Akenine-Moller, Assarsson 2002; Assarsson, Akenine-Moller 2003",
        .represents = kShadingEffects | EffectSet{Effect::OpaqueCasters,
                                                  Effect::TranslucentReceivers, Effect::AreaLights},
        .requires_ = {rhi::Feature::DepthClamp},
        .knobs = knobs(),
        .error = "where casters, or layers of one, overlap before a light they hide it twice; "
                 "silhouettes are those of the light's centre; perforated casters are whole",
        .breaksIn = breaks(),
        .receiversByLayer = true}));

}  // namespace
}  // namespace sb
