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
#include "techniques/volumes/volume_technique.h"
#include "techniques/volumes/wedges/soft_shadows.h"

namespace sb {
namespace {

class PenumbraWedge final : public VolumeTechnique {
 public:
  void recordReceivers(Frame& frame, const ReceiverLayer& layer) override {
    const std::vector<LightVolumes>& lights = volumes().lights();
    size_t soft = 0;
    for (uint32_t slot = 0; slot < lights.size(); ++slot) {
      if (!isSoft(lights[slot]))
        m_hard->record(frame, layer, volumes(), std::span(lights).subspan(slot, 1), mask(), slot);
      else
        m_soft->record({frame, layer, volumes(), lights[slot], soft++, mask(), slot});
    }
  }

  std::vector<std::pair<std::string, uint64_t>> counts() const override {
    auto counts = VolumeTechnique::counts();
    counts.emplace_back("penumbra wedges", m_wedges->count());
    // Not shown to hold their penumbra.
    counts.emplace_back("penumbra wedges drawn everywhere", m_wedges->everywhere());
    return counts;
  }

 private:
  Choices choose(const Context& context) override {
    m_wedges.emplace(context);
    return {.volumes = {.addsUp = true, .byLoops = context.knobs.is("combine", "loop")},
            .culling = {.extents = context.plan.runs(Effect::AreaLights)}};
  }

  void visit(const std::vector<LightVolumes>& lights) override {
    const std::vector<const LightVolumes*> softNow = softOf(lights);
    m_wedges->reserve(softNow);
    for (const LightVolumes* light : softNow) m_softOnes.push_back(*light);
    // Another eye may see a penumbra as a hard edge.
    for (const LightVolumes& light : lights)
      if (context().view.isFree() || !isSoft(light)) m_hardOnes.push_back(light);
  }

  MaskKind maskKind() const override {
    return m_softOnes.empty() ? MaskKind::Binary : MaskKind::Share;
  }

  void prepareShadows() override {
    m_hard.emplace(context(), CounterKind::Stencil, VolumeFaces::Both);
    m_hard->prepare(volumes(), m_hardOnes, mask());
    if (m_softOnes.empty()) return;
    m_wedges->createBuffers();
    m_soft = SoftShadows::make(context(), *m_wedges);
    m_soft->prepare(volumes(), m_softOnes, mask());
  }

  void writeStep(const ShadowMask::Write& write) override {
    if (m_soft) m_wedges->find(volumes(), softOf(volumes().lights()), write);
  }

  /// Its penumbrae may be a pixel wide.
  bool isSoft(const LightVolumes& light) const {
    const SceneView& view = context().view;
    return context().plan.runs(Effect::AreaLights) &&
           isAreaLight(view.placed().light(light.light)) &&
           view.effects().lights[light.light].penumbra * view.size().height >= 1;
  }
  std::vector<const LightVolumes*> softOf(const std::vector<LightVolumes>& lights) const {
    std::vector<const LightVolumes*> soft;
    for (const LightVolumes& light : lights)
      if (isSoft(light)) soft.push_back(&light);
    return soft;
  }

  std::vector<LightVolumes> m_hardOnes, m_softOnes;  ///< of all steps
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
