// Composited translucent shadows (Modisett 2023, section 4.2.3) and better partitions of it; spec 05.
// Every translucent receiver reads the colour behind those casters alone that lie before it. Right
// at every receiver up to texels and the rounding of the colour; no noise.
//   partition=levels   one map a level of the light-space overlap graph, each caster drawn once;
//                      what has no order (cycles, surfaces that shadow themselves) is peeled on
//                      its level
//   partition=peeled   layers peeled from the light: exact per texel, a pass a layer
//   partition=batches  one map, made anew for each run of receivers that may share it
//   partition=source   one map, made anew for each translucent mesh: Modisett's, quadratic
// The last two make maps between the camera's draws, and so need sorted meshes; surfaces that are
// opaque to the camera but not to light read the map of all casters there.
#include <algorithm>

#include "shaders/common/shared_slots.h"
#include "techniques/maps/opaque_casters.h"
#include "techniques/maps/translucent_maps.h"
#include "techniques/partition/receiver_parts.h"
#include "techniques/partition/view_levels.h"
#include "techniques/render/registry.h"

namespace sb {
namespace {

class CompositedTranslucent final : public ShadowTechnique {
 public:
  void prepare(const Context& context) override {
    m_view = &context.view;
    m_context.emplace(context);
    m_maps.emplace(context, 0.0f, DepthShape{.reachTranslucent = true});
    m_translucent = context.plan.runs(Effect::TranslucentCasters);
    m_opaque.emplace(context, *m_maps);
    if (m_translucent) createTranslucent(context);
    m_constants = m_maps->constants(context.knobs);
    m_constants.push_back({19, m_translucent});
    m_constants.push_back({20, m_peel && !m_peel->empty()});
    m_constants.push_back({21, m_nearest.id() != rhi::TextureId{}});
    createReceivers(context);
  }

  void cameraMoved(Frame& frame) override {
    if (m_levelled) planLevels();
    if (m_peel) m_peel->use(m_view->step());
    planParts();
    const std::vector<glm::uvec4> table = receiverTable();
    frame.commands().write(m_receivers, 0, std::as_bytes(std::span(table)));
  }

  void record(Frame& frame) override {
    for (size_t i = 0; i < m_maps->views().size(); ++i) {
      const LightView& view = m_maps->views()[i];
      if (view.layer() < 0) continue;
      frame.pass({.label = "shadow map", .depth = m_maps->depthAttachment(view)}, PassGroup::Shadow,
                 [&](rhi::CommandList& commands) { m_opaque->draw(commands, i); });
      if (!m_translucent) continue;
      if (m_levelled)
        recordLevels(frame, i);
      else
        recordAll(frame, i, view.translucent);
    }
    if (m_peel) m_peel->record(frame);
  }

  std::span<const std::vector<uint32_t>> parts() const override { return m_parts.receivers; }

  void recordPart(Frame& frame, size_t part) override {
    for (size_t i = 0; i < m_maps->views().size(); ++i)
      if (m_maps->views()[i].layer() >= 0) recordAll(frame, i, m_parts.casters[part][i]);
  }

  VisibilityInputs inputs() const override {
    const rhi::TextureId opaque = m_maps->depth();
    VisibilityInputs inputs{.bindings = {rhi::storageAt(STORAGE_TECHNIQUE, m_receivers)},
                            .reads = {},
                            .constants = m_constants};
    const auto bind = [&](uint32_t slot, rhi::TextureId map, bool read) {
      inputs.bindings.push_back(
          rhi::textureAt(TEXTURE_TECHNIQUE + slot, read ? map : opaque, m_maps->pointSampler()));
      if (read) inputs.reads.push_back(rhi::use(map, rhi::Access::Sampled));
    };
    bind(0, opaque, true);
    bind(1, m_colour, m_colour.id() != rhi::TextureId{});
    bind(2, m_nearest, m_nearest.id() != rhi::TextureId{});
    bind(3, m_peel ? m_peel->depth().id() : opaque, m_peel.has_value());
    bind(4, m_peel ? m_peel->colour().id() : opaque, m_peel.has_value());
    return inputs;
  }

  std::vector<std::pair<std::string, rhi::TextureId>> maps() const override {
    std::vector<std::pair<std::string, rhi::TextureId>> list = {{"depth", m_maps->depth()}};
    if (m_colour.id() != rhi::TextureId{}) list.emplace_back("colours", m_colour);
    if (m_nearest.id() != rhi::TextureId{}) list.emplace_back("translucent depth", m_nearest);
    if (m_peel) list.emplace_back("peeled depth", m_peel->depth());
    if (m_peel) list.emplace_back("peeled colour", m_peel->colour());
    return list;
  }

  LookupReach reach(uint32_t light) const override { return m_maps->reach(light); }

 private:
  void createTranslucent(const Context& context) {
    m_partition = context.knobs.text("partition");
    m_cap = context.knobs.integer("levels");
    m_format = colourMapFormat(context.knobs);
    m_levelled = m_partition == "levels" || m_partition == "peeled";
    uint32_t layers = std::max(1u, m_maps->layers());
    if (m_levelled) layers = createLevels(context);
    if (layers > 0) {
      m_colour = m_maps->createLike(context, "shadow colour", m_format, layers);
      m_colourPipeline = context.pipeline(
          colourPipeline(context, *m_maps, "composited_translucent/colour.frag", m_format));
      if (m_levelled && m_view->steps() > 1) ShadowMaps::clear(context, m_colour);
    }
    if (m_levelled) return;
    m_nearest = m_maps->createLike(context, "translucent depth", m_maps->depthFormat());
    m_nearestPipeline =
        m_maps->pipelines(context, m_maps->casterPipeline(context, "translucent depth",
                                                          "translucent_shadows/depth.frag", false));
    // Nothing lies in another's shadow: one map serves all (spec 05, "Skip").
    m_inParts = context.plan.runs(Effect::TranslucentOverlap);
    planParts();
  }

  /// Levels and peeled groups of all views at every step; returns the layers that the colour map
  /// needs.
  uint32_t createLevels(const Context& context) {
    std::vector<std::vector<PeelGroup>> steps;
    uint32_t most = 0;
    context.view.alongPath(context.device, [&] {
      planLevels();
      most = std::max(most, m_levels.layers());
      for (PeelGroup& group : steps.emplace_back(m_levels.groups()))
        group.count = LightPeel::countLayers(
            context, *m_maps, group,
            [&](rhi::CommandList& commands, size_t view) { m_opaque->draw(commands, view); });
    });
    if (std::ranges::any_of(steps, [](const auto& groups) { return !groups.empty(); }))
      m_peel.emplace(context, *m_maps, std::move(steps), m_cap, m_format);
    return most;
  }

  void planLevels() { m_levels.plan(*m_view, *m_maps, m_partition == "peeled", m_cap); }

  void planParts() {
    if (!m_inParts) return;
    m_parts =
        m_partition == "source" ? meshParts(*m_context, *m_maps) : batchParts(*m_view, *m_maps);
  }

  void createReceivers(const Context& context) {
    const std::vector<glm::uvec4> table = receiverTable();
    m_receivers =
        context.device.createBuffer({.label = "receiver layers",
                                     .size = table.size() * sizeof table[0],
                                     .use = rhi::BufferUse::Storage | rhi::BufferUse::CopyTarget});
    context.device.upload(m_receivers, 0, std::as_bytes(std::span(table)));
  }

  /// For each view and instance what it reads, see shaders/composited_translucent/visibility.glsl.
  std::vector<glm::uvec4> receiverTable() const {
    const uint32_t instances = uint32_t(m_view->scene().instances.size());
    std::vector<glm::uvec4> table = {glm::uvec4(instances, 0, 0, 0)};
    for (size_t i = 0; i < m_maps->views().size(); ++i) {
      // Whatever is no node lies behind every caster before the first opaque surface.
      glm::uvec4 behindAll(0);
      if (m_translucent && !m_levelled)
        behindAll.x = 1 + uint32_t(std::max(0, m_maps->views()[i].layer()));
      if (m_levelled && m_colour.id() != rhi::TextureId{})
        behindAll.x = m_levels.layerBehind(i, uint32_t(m_levels.of(i).casters.size()));
      else if (const PeelGroup* all = m_levelled ? m_levels.group(m_peel, i, 0) : nullptr)
        behindAll = {0, all->first, all->count, 0};
      table.resize(table.size() + instances, behindAll);
      if (!m_levelled) continue;
      for (const auto& r : m_levels.of(i).receivers) {
        glm::uvec4& entry = table[table.size() - instances + r.instance];
        entry = {m_colour.id() != rhi::TextureId{} ? m_levels.layerBehind(i, r.level) : 0, 0, 0, 0};
        const PeelGroup* group = r.peeled ? m_levels.group(m_peel, i, r.level) : nullptr;
        if (group) entry = {entry.x, group->first, group->count, 0};
      }
    }
    return table;
  }

  void recordLevels(Frame& frame, size_t i) {
    if (m_colour.id() == rhi::TextureId{}) return;
    const std::vector<std::vector<uint32_t>>& casters = m_levels.of(i).casters;
    for (uint32_t level = 0; level < casters.size(); ++level) {
      const uint32_t layer = m_levels.layer(i, level);
      if (level > 0)
        frame.commands().copy({.texture = m_colour,
                               .baseMip = 0,
                               .mipCount = 1,
                               .baseLayer = layer - 1,
                               .layerCount = 1},
                              {.texture = m_colour,
                               .baseMip = 0,
                               .mipCount = 1,
                               .baseLayer = layer,
                               .layerCount = 1});
      recordColourPass(
          frame, *m_maps, m_maps->views()[i], m_colour, layer,
          [&](rhi::CommandList& commands) {
            m_maps->surfaces(i).draw(commands, m_colourPipeline, casters[level]);
          },
          level > 0 ? rhi::LoadOp::Load : rhi::LoadOp::Clear);
    }
  }

  /// Nearest depth of some casters of a view and the colour behind them, as in technique 02.
  void recordAll(Frame& frame, size_t i, const std::vector<uint32_t>& casters) {
    const LightView& view = m_maps->views()[i];
    rhi::DepthAttachment depth = m_maps->depthAttachment(view);
    depth.view.texture = m_nearest;
    frame.pass({.label = "translucent depth", .depth = depth}, PassGroup::Shadow,
               [&](rhi::CommandList& commands) {
                 m_maps->surfaces(i).draw(commands, m_nearestPipeline, casters);
               });
    recordColourPass(frame, *m_maps, view, m_colour, uint32_t(view.layer()),
                     [&](rhi::CommandList& commands) {
                       m_maps->surfaces(i).draw(commands, m_colourPipeline, casters);
                     });
  }

  const SceneView* m_view = nullptr;
  std::optional<const Context> m_context;
  std::optional<ShadowMaps> m_maps;
  std::string m_partition;
  uint32_t m_cap = 0;      ///< knob levels
  bool m_inParts = false;  ///< maps are made for parts of the picture
  bool m_translucent = false;
  bool m_levelled = false;  ///< maps serve all receivers: levels or peeled layers
  rhi::Format m_format = rhi::Format::Undefined;
  rhi::Texture m_colour, m_nearest;
  rhi::Buffer m_receivers;
  std::optional<OpaqueCasters> m_opaque;
  CasterPipelines m_nearestPipeline;
  rhi::PipelineId m_colourPipeline;
  ViewLevels m_levels;
  std::optional<LightPeel> m_peel;
  ReceiverParts m_parts;
  std::vector<rhi::SpecConstant> m_constants;
};

std::vector<KnobInfo> knobs() {
  std::vector<KnobInfo> list = shadowMapKnobs("1");
  list.push_back(colourFormatKnob());
  list.push_back({.name = "partition",
                  .help = "how casters are spread over maps: levels of the overlap graph, peeled "
                          "layers, batches of receivers, or a map for each mesh (Modisett 2023)",
                  .fallback = "levels",
                  .choices = {"levels", "peeled", "batches", "source"},
                  .sweep = {"levels", "peeled", "batches", "source"}});
  list.push_back({.name = "levels",
                  .unit = "maps",
                  .help = "most levels, and most peeled layers of a level; deeper ones are peeled, "
                          "or share one product",
                  .fallback = "32",
                  .min = 1,
                  .max = 256});
  return list;
}

constexpr const char* kByCentres = "meshes are taken one by one, in the order of their centres";
constexpr const char* kOneMesh = "a mesh has one map, in which it does not shadow itself";

bool makesMapsBetween(const Knobs& knobs) {
  return knobs.is("partition", "source") || knobs.is("partition", "batches");
}

REGISTER_TECHNIQUE(
    ShadowTechnique, CompositedTranslucent,
    (TechniqueInfo{
        .name = "CompositedTranslucent",
        .folder = "composited_translucent",
        .title = "Composited translucent shadows: a colour for each set of casters before "
                 "a receiver",
        .paper = "Modisett 2023, section 4.2.3; levels, batches and peeling: this project",
        .represents = kShadingEffects |
                      EffectSet{Effect::OpaqueCasters, Effect::PerforatedCasters,
                                Effect::TranslucentCasters, Effect::ColouredTransmission,
                                Effect::TexturedTransmission, Effect::TranslucentReceivers,
                                Effect::TranslucentOverlap},
        .knobs = knobs(),
        .error = "edges move by half a texel; partition source orders by centres, and "
                 "coplanar layers peel as one",
        .breaksIn = {{"coplanar partition:peeled", "layers of one depth peel as one"},
                     {"cycle partition:source", kByCentres},
                     {"crossing partition:source", kByCentres},
                     {"closed partition:source", kOneMesh},
                     {"closed partition:batches", kOneMesh}},
        .drawsInParts = makesMapsBetween}));

}  // namespace
}  // namespace sb
