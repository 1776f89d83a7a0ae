// Stencil shadow volumes (Crow 1977; Heidmann 1991; Carmack and Bilodeau 2000; Everitt and Kilgard
// 2002; Kastrup and others); spec 07. For each layer of receivers and each light: the volumes that
// casters keep from the light are counted at the receiver's depth, entered less left, and where the
// count is not 0 a mask says so, a channel a light. Exact to the pixel; hard shadows alone. Costs
// two passes a light and fill over all that volumes cover in the picture.
//   count=zpass       before the receiver: wrong where the eye stands in a volume
//   casts=light,back  one side of every mesh: wrong for open ones, and within closed ones
//   counter=stencil8  256 volumes around a point are none
//   lights=single     the source's approximation: all lights in one count, which darkens all of
//                     them by one share
//   extrusion=finite  the source's: the far end cuts a corner of R (1 - cos(phi / 2)) off, R the
//                     reach, phi the angle under which the light sees a triangle
#include <bit>

#include "shaders/common/shared_types.h"
#include "techniques/render/registry.h"
#include "techniques/volumes/volume_technique.h"

namespace sb {
namespace {

VolumeBuilder builderOf(const Knobs& knobs) {
  if (knobs.is("build", "vertex")) return VolumeBuilder::Vertex;
  if (knobs.is("build", "geometry")) return VolumeBuilder::Geometry;
  return knobs.is("build", "compute") ? VolumeBuilder::Compute : VolumeBuilder::Cpu;
}

VolumeChoice choiceOf(const Knobs& knobs) {
  VolumeChoice choice{.finite = knobs.is("extrusion", "finite")};
  if (!knobs.is("count", "auto"))
    choice.count = knobs.is("count", "zpass") ? DepthCount::Pass : DepthCount::Fail;
  if (!knobs.is("casts", "auto"))
    choice.casts = knobs.is("casts", "light")  ? CASTS_LIGHT
                   : knobs.is("casts", "back") ? CASTS_BACK
                                               : CASTS_ALL;
  return choice;
}

CullingChoice cullingOf(const Knobs& knobs) {
  return {.cull = knobs.is("cull", "full"),
          .tree = knobs.is("tree", "quadtree") ? TreeKind::QuadTree
                  : knobs.is("tree", "bvh")    ? TreeKind::Boxes
                                               : TreeKind::List,
          .budget = knobs.integer("budget")};
}

class StencilShadowVolume final : public VolumeTechnique {
 public:
  void recordReceivers(Frame& frame, const ReceiverLayer& layer) override {
    const std::span<const LightVolumes> lights = volumes().lights();
    const uint32_t count = slotCount(volumes().lights());
    for (uint32_t slot = 0; slot < count; ++slot)
      m_shadows->record(frame, layer, volumes(), m_single ? lights : lights.subspan(slot, 1),
                        mask(), slot);
  }

  VisibilityInputs inputs() const override {
    VisibilityInputs inputs = VolumeTechnique::inputs();
    if (hasMask())
      inputs.constants = {{16, std::bit_cast<uint32_t>(m_single ? 1 - m_darkness : 0.0f)}};
    return inputs;
  }

 private:
  Choices choose(const Context& context) override {
    const Knobs& knobs = context.knobs;
    m_single = knobs.is("lights", "single");
    m_darkness = knobs.number("darkness");
    m_shadows.emplace(context,
                      knobs.is("counter", "float") ? CounterKind::Float : CounterKind::Stencil,
                      knobs.is("sides", "one") ? VolumeFaces::Each : VolumeFaces::Both);
    return {builderOf(knobs), choiceOf(knobs), cullingOf(knobs)};
  }
  void visit(const std::vector<LightVolumes>& lights) override {
    m_united.insert(m_united.end(), lights.begin(), lights.end());
  }
  void prepareShadows() override { m_shadows->prepare(volumes(), m_united, mask()); }

  /// One a light, or one for all of them.
  uint32_t slotCount(const std::vector<LightVolumes>& lights) const override {
    return m_single ? std::min<uint32_t>(1, uint32_t(lights.size())) : uint32_t(lights.size());
  }
  std::vector<uint32_t> slots(const std::vector<LightVolumes>& lights) const override {
    std::vector<uint32_t> slots = VolumeTechnique::slots(lights);
    for (uint32_t& slot : slots)
      if (m_single) slot = lights.empty() ? NO_SHADOW : 0;
    return slots;
  }

  bool m_single = false;
  float m_darkness = 0;                ///< share of light that is taken where all lights count as one
  std::vector<LightVolumes> m_united;  ///< of all steps
  std::optional<HardShadows> m_shadows;
};

std::vector<KnobInfo> knobs() {
  return {
      {.name = "count",
       .help = "volumes before the receiver or behind it; auto: what is right for each caster",
       .fallback = "auto",
       .choices = {"auto", "zpass", "zfail"},
       .sweep = {"zpass", "zfail", "auto"}},
      {.name = "sides",
       .help = "two-sided stencil, or draws for each side",
       .fallback = "two",
       .choices = {"two", "one"},
       .sweep = {"two", "one"}},
      {.name = "counter",
       .help = "what counts volumes: modulo 256, or to 2^24",
       .fallback = "stencil8",
       .choices = {"stencil8", "float"},
       .sweep = {"stencil8", "float"}},
      {.name = "casts",
       .help = "triangles that cast: facing the light, the others, all; auto: the others of "
               "closed meshes that hold neither light nor eye, else all",
       .fallback = "auto",
       .choices = {"auto", "light", "back", "all"},
       .sweep = {"light", "back", "auto", "all"}},
      {.name = "build",
       .help = "where silhouettes are found; all give the same picture",
       .fallback = "cpu",
       .choices = {"cpu", "vertex", "geometry", "compute"},
       .sweep = {"cpu", "vertex", "geometry", "compute"}},
      {.name = "lights",
       .help = "a count for each light, or one for all, which darkens all of them (approximate)",
       .fallback = "multi",
       .choices = {"multi", "single"},
       .sweep = {"single", "multi"}},
      {.name = "darkness",
       .help = "share of all light that lights=single takes in a shadow of any",
       .fallback = "0.5",
       .min = 0,
       .max = 1,
       .integer = false},
      {.name = "extrusion",
       .help = "how far from the light volumes reach: to infinity, or as far as its light",
       .fallback = "infinite",
       .choices = {"infinite", "finite"},
       .sweep = {"finite", "infinite"}},
      {.name = "cull",
       .help = "leave out volumes that no pixel can show, or draw each caster in each light",
       .fallback = "full",
       .choices = {"full", "none"},
       .sweep = {"none", "full"}},
      {.name = "tree",
       .help = "what finds casters, receivers and lights: squares of the ground, boxes in boxes, "
               "each in turn; all give the same picture",
       .fallback = "quadtree",
       .choices = {"quadtree", "bvh", "none"},
       .sweep = {"none", "quadtree", "bvh"}},
      {.name = "budget",
       .unit = "triangles",
       .help = "of casters a frame, the most important volumes first; the others throw no shadow; "
               "0: no limit",
       .fallback = "0",
       .min = 0,
       .max = 4294967295.0,
       .sweep = {}}};
}

std::map<std::string, std::string> breaks() {
  std::map<std::string, std::string> breaks = {
      {"overlaps", "the stencil counts modulo 256: as many layers are none"}};
  const auto variant = [&](const char* knob, const char* why,
                           std::initializer_list<const char*> cases) {
    for (const char* id : cases) breaks[std::string(id) + " " + knob] = why;
  };
  variant("count:zpass", "the eye stands in a volume, whose entry lies behind it",
          {"far caster", "range", "inside", "concave contact", "contact", "eye in shadow",
           "near across"});
  variant("casts:back", "no triangle of an open caster has its back to the light",
          {"far caster", "range", "concave contact", "contact"});
  variant("casts:light", "no triangle around a light within a caster faces it", {"inside"});
  variant("lights:single", "all light is darkened by one share, whichever light is in shadow",
          {"far caster", "range", "inside", "concave contact", "contact", "eye in shadow",
           "not closed", "H3"});
  variant("extrusion:finite", "the far end cuts off what the light sees under a wide angle",
          {"far caster", "range"});
  return breaks;
}

REGISTER_TECHNIQUE(
    ShadowTechnique, StencilShadowVolume,
    (TechniqueInfo{
        .name = "StencilShadowVolume",
        .folder = "stencil_shadow_volume",
        .title = "Stencil shadow volumes, hard shadows exact to the pixel",
        .paper = "Crow 1977; Heidmann 1991; Everitt, Kilgard 2002",
        .represents = kShadingEffects |
                      EffectSet{Effect::OpaqueCasters, Effect::TranslucentReceivers},
        .requires_ = {rhi::Feature::DepthClamp},
        .knobs = knobs(),
        .error = "none for opaque casters and lights without extent; perforated casters are whole",
        .breaksIn = breaks(),
        .receiversByLayer = true}));

}  // namespace
}  // namespace sb
