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

#include "shaders/common/shared_slots.h"
#include "shaders/common/shared_types.h"
#include "techniques/render/camera_pass.h"
#include "techniques/render/registry.h"
#include "techniques/render/screen_targets.h"
#include "techniques/volumes/volume_counter.h"

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

class StencilShadowVolume final : public ShadowTechnique {
 public:
  void prepare(const Context& context) override {
    m_view = &context.view;
    m_float = context.knobs.is("counter", "float");
    m_single = context.knobs.is("lights", "single");
    m_darkness = context.knobs.number("darkness");
    m_counter.emplace(context, m_float ? CounterKind::Float : CounterKind::Stencil,
                      context.knobs.is("sides", "one") ? VolumeFaces::Each : VolumeFaces::Both);
    m_volumes.emplace(context, builderOf(context.knobs), choiceOf(context.knobs), cullingOf(context.knobs),
                      [&](const std::vector<LightVolumes>& lights) {
                        m_mostLights = std::max(m_mostLights, channels(lights));
                        m_mostInView = std::max(m_mostInView, uint32_t(slots(lights).size()));
                        m_united.insert(m_united.end(), lights.begin(), lights.end());
                      });
    m_counter->prepare(*m_volumes, m_united);
    m_united.clear();
    if (m_mostLights == 0) return;
    createTargets(context);
    createMaskPipelines(context);
    if (context.view.steps() > 1) return;  // each frame writes its own
    const std::vector<uint32_t> now = slots(m_volumes->lights());
    context.device.upload(m_slots, 0, std::as_bytes(std::span(now)));
  }

  void moved(Frame& frame) override {
    m_volumes->moved(frame);
    const std::vector<uint32_t> now = slots(m_volumes->lights());
    if (m_slots && !now.empty()) frame.commands().write(m_slots, 0, std::as_bytes(std::span(now)));
  }

  void record(Frame& frame) override { m_volumes->record(frame); }

  void recordReceivers(Frame& frame, const ReceiverLayer& layer) override {
    const std::span<const LightVolumes> lights = m_volumes->lights();
    const uint32_t count = channels(m_volumes->lights());
    for (uint32_t slot = 0; slot < count; ++slot) {
      recordVolumes(frame, layer, m_single ? lights : lights.subspan(slot, 1));
      recordMask(frame, layer, slot);
    }
  }

  std::vector<std::pair<std::string, uint64_t>> counts() const override {
    return m_volumes->counts();
  }

  VisibilityInputs inputs() const override {
    // Translucent casters alone throw no shadow here.
    if (m_mostLights == 0)
      return {
          .bindings = {}, .reads = {}, .constants = {}, .folder = baselineTechnique().info.folder};
    return {.bindings = {rhi::textureAt(TEXTURE_TECHNIQUE, m_mask, m_sampler),
                         rhi::storageAt(STORAGE_TECHNIQUE, m_slots)},
            .reads = {rhi::use(m_mask.id(), rhi::Access::Sampled)},
            .constants = {{16, std::bit_cast<uint32_t>(m_single ? 1 - m_darkness : 0.0f)}}};
  }

 private:
  static constexpr uint32_t kChannels = 4;

  /// Of the mask: one a light, or one for all of them.
  uint32_t channels(const std::vector<LightVolumes>& lights) const {
    return m_single ? std::min<uint32_t>(1, uint32_t(lights.size())) : uint32_t(lights.size());
  }

  /// Channel of the mask of each light in view.
  std::vector<uint32_t> slots(const std::vector<LightVolumes>& lights) const {
    std::vector<uint32_t> slots;
    for (const LightEffects& light : m_view->effects().lights) {
      if (!light.touchesView) continue;
      const auto at =
          m_single ? lights.begin() : std::ranges::find(lights, light.light, &LightVolumes::light);
      slots.push_back(at == lights.end() ? NO_SHADOW : uint32_t(at - lights.begin()));
    }
    return slots;
  }

  void createTargets(const Context& context) {
    using U = rhi::TextureUse;
    const auto [width, height] = context.view.size();
    m_maskFormat = m_mostLights == 1   ? rhi::Format::R8Unorm
                   : m_mostLights == 2 ? rhi::Format::RG8Unorm
                                       : rhi::Format::RGBA8Unorm;
    m_mask = context.device.createTexture(
        {.label = "shadow mask",
         .kind = rhi::TextureKind::Tex2DArray,
         .format = m_maskFormat,
         .width = width,
         .height = height,
         .layers = std::max(1u, (m_mostLights + kChannels - 1) / kChannels),
         .use = U::ColorTarget | U::Sampled | U::CopyTarget});
    // Steps in which nothing casts write none of it.
    const std::vector<std::byte> lit(size_t(width) * height * kChannels, std::byte{0xFF});
    const size_t bytes = size_t(width) * height * rhi::formatInfo(m_maskFormat).texelBytes;
    for (uint32_t layer = 0; layer * kChannels < m_mostLights && !context.view.stands(); ++layer)
      context.device.upload(m_mask, {.layer = layer}, std::span(lit).first(bytes));
    if (m_float)
      m_counts = screenTarget(context, "shadow volume counts", VolumeCounter::kFloatFormat);
    m_slots =
        context.device.createBuffer({.label = "shadow mask slots",
                                     .size = std::max<uint64_t>(16, 4 * uint64_t(m_mostInView)),
                                     .use = rhi::BufferUse::Storage | rhi::BufferUse::CopyTarget});
    m_sampler = context.device.createSampler(
        {.label = "shadow mask sampler", .filter = rhi::Filter::Nearest});
  }

  void createMaskPipelines(const Context& context) {
    const rhi::StencilFace counted = {.compare = rhi::CompareOp::NotEqual};
    for (uint32_t channel = 0; channel < std::min(m_mostLights, kChannels); ++channel) {
      rhi::GraphicsPipelineDesc desc{
          .label = "shadow mask",
          .vertex = &context.shaders.get("common/fullscreen.vert"),
          .fragment = &context.shaders.get(m_float ? "stencil_shadow_volume/counted.frag"
                                                   : "stencil_shadow_volume/shadowed.frag"),
          .targets = {{.format = m_maskFormat, .writeMask = uint8_t(1u << channel)}}};
      if (!m_float) {
        desc.stencil = {.test = true, .front = counted, .back = counted};
        desc.depthFormat = VolumeCounter::kDepthFormat;
      }
      m_maskPipelines.push_back(context.pipeline(desc));
    }
  }

  void recordVolumes(Frame& frame, const ReceiverLayer& layer,
                     std::span<const LightVolumes> lights) const {
    const rhi::ColorAttachment counts{.view = {.texture = m_counts}};
    const std::vector<rhi::ResourceUse> reads = m_volumes->reads();
    frame.pass({.label = "shadow volumes",
                .colors = std::span(&counts, m_float ? 1 : 0),
                .depth = rhi::DepthAttachment{.view = {.texture = layer.depth},
                                              .load = rhi::LoadOp::Load,
                                              .readOnly = true},
                .reads = reads},
               PassGroup::Shadow, [&](rhi::CommandList& commands) {
                 for (const LightVolumes& light : lights)
                   m_counter->draw(commands, *m_volumes, light);
               });
  }

  /// The channels of a layer are lit until a light says otherwise.
  void recordMask(Frame& frame, const ReceiverLayer& layer, uint32_t slot) const {
    const rhi::ColorAttachment mask{
        .view = {.texture = m_mask, .baseLayer = slot / kChannels, .layerCount = 1},
        .load = slot % kChannels == 0 ? rhi::LoadOp::Clear : rhi::LoadOp::Load,
        .clear = {1, 1, 1, 1}};
    rhi::PassDesc pass{.label = "shadow mask", .colors = std::span(&mask, 1)};
    const rhi::ResourceUse counts = rhi::use(m_counts.id(), rhi::Access::Sampled);
    std::vector<rhi::Binding> bindings;
    if (m_float) {
      pass.reads = {&counts, 1};
      bindings = {rhi::textureAt(TEXTURE_TECHNIQUE, m_counts, m_sampler)};
    } else {
      pass.depth = rhi::DepthAttachment{.view = {.texture = layer.depth},
                                        .load = rhi::LoadOp::Load,
                                        .readOnly = true,
                                        .stencilLoad = rhi::LoadOp::Load,
                                        .stencilReadOnly = true};
    }
    frame.pass(pass, PassGroup::Shadow, [&](rhi::CommandList& commands) {
      drawFullscreen(commands, m_maskPipelines[slot % kChannels], bindings);
    });
  }

  const SceneView* m_view = nullptr;
  bool m_float = false, m_single = false;
  float m_darkness = 0;       ///< share of light that is taken where all lights count as one
  uint32_t m_mostLights = 0;  ///< that something casts in, at any step
  uint32_t m_mostInView = 0;
  std::vector<LightVolumes> m_united;
  std::optional<ShadowVolumes> m_volumes;
  std::optional<VolumeCounter> m_counter;
  rhi::Format m_maskFormat = rhi::Format::Undefined;
  rhi::Texture m_mask, m_counts;
  rhi::Buffer m_slots;
  rhi::Sampler m_sampler;
  std::vector<rhi::PipelineId> m_maskPipelines;  ///< by channel
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
