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
//   combine=loop    the source's: a buffer for each loop of a silhouette, in which its edges say
//                   where it hides the light's centre; wrong for loops that are not convex
//   combine=split   the first source's: both halves of each wedge by themselves, in which shares
//                   have one sign; four draws a wedge
//   coverage=lut    the source's tables in place of the closed form
//   format=rgba8    the source's buffer: shares in steps of 1/32, of which eight may overlap
// Casters that overlap before the light, and layers of one mesh that do, hide it twice; silhouettes
// are those of the light's centre; shares are of the disc, whatever the receiver's horizon.
#include "techniques/render/registry.h"
#include "techniques/scene/light_area.h"
#include "techniques/volumes/hard_shadows.h"
#include "techniques/volumes/soft_shadows.h"

namespace sb {
namespace {

using Volumes = std::vector<const LightVolumes*>;

class PenumbraWedge final : public ShadowTechnique {
 public:
  void prepare(const Context& context) override {
    m_context.emplace(context);
    m_wedges.emplace(context);
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
    m_volumes.emplace(context, VolumeBuilder::Cpu, VolumeChoice{.addsUp = true, .byLoops = context.knobs.is("combine", "loop")},
                      culling, visit);
    if (mostLights == 0) return;
    m_mask.emplace(context, soft.empty() ? MaskKind::Binary : MaskKind::Share, mostLights,
                   mostInView);
    m_hard.emplace(context, CounterKind::Stencil, VolumeFaces::Both);
    m_hard->prepare(*m_volumes, hard, *m_mask);
    if (!soft.empty()) {
      m_wedges->createBuffers();
      m_soft = SoftShadows::make(context, *m_wedges);
      m_soft->prepare(*m_volumes, soft, *m_mask);
    }
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
        m_soft->record({frame, layer, *m_volumes, lights[slot], soft++, *m_mask, slot});
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
    if (m_soft) m_wedges->find(*m_volumes, softOf(m_volumes->lights()), write);
  }

  std::optional<Context> m_context;
  std::optional<ShadowVolumes> m_volumes;
  std::optional<ShadowMask> m_mask;
  std::optional<HardShadows> m_hard;
  std::optional<LightWedges> m_wedges;
  std::unique_ptr<SoftShadows> m_soft;
};

std::vector<KnobInfo> knobs() {
  return {{.name = "combine",
           .help = "how volumes and wedges are combined: sums, put right by caster near hard edges "
                   "(shader), not at all (float), by their range (wrap); no sums (exact); convex "
                   "outlines one by one (loop); halves of wedges one by one (split)",
           .fallback = "shader",
           .choices = {"shader", "float", "wrap", "exact", "loop", "split"},
           .sweep = {"float", "wrap", "loop", "split", "shader", "exact"}},
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
           .help = "of sums; rgba8: the source's, in steps of 1/32 (not of combine=loop, split)",
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
        .refuses =
            [](const Knobs& knobs) {
              const bool apart = knobs.is("combine", "loop") || knobs.is("combine", "split");
              return std::string(apart && knobs.is("format", "rgba8")
                                     ? "bytes hold no shares below 0, which combine=" +
                                           knobs.text("combine") + " adds"
                                     : "");
            },
        .receiversByLayer = true}));

}  // namespace
}  // namespace sb
