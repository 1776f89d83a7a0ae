// Composited translucent shadows (seed 000, section 4.2.3) and better partitions of it; spec 05.
// Every translucent receiver reads the colour behind those casters alone that lie before it. Right
// at every receiver up to texels and the rounding of the colour; no noise.
//   partition=levels   one map a level of the light-space overlap graph, each caster drawn once;
//   what
//                    has no order (cycles, surfaces that shadow themselves) is peeled on its level
//   partition=peeled   layers peeled from the light: exact per texel, a pass a layer
//   partition=batches  one map, made anew for each run of receivers that may share it
//   partition=source   one map, made anew for each translucent mesh: seed 000's, quadratic
// The last two make maps between the camera's draws, and so need sorted meshes; surfaces that are
// opaque to the camera but not to light read the map of all casters there.
#include <algorithm>

#include "shaders/common/shared_slots.h"
#include "techniques/common/light_batches.h"
#include "techniques/common/light_levels.h"
#include "techniques/common/light_order.h"
#include "techniques/common/registry.h"
#include "techniques/common/view_order.h"

namespace sb {
namespace {

class CompositedTranslucent final : public ShadowTechnique {
 public:
  void prepare(const Context& context) override {
    m_view = &context.view;
    m_context.emplace(context);
    m_maps.emplace(context, 0.0f);
    m_translucent = context.plan.runs(Effect::TranslucentCasters);
    createOpaque(context);
    if (m_translucent) createTranslucent(context);
    m_constants = ShadowMaps::constants(context.knobs);
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
                 [&](rhi::CommandList& commands) { drawOpaque(commands, i); });
      if (!m_translucent) continue;
      if (m_levelled)
        recordLevels(frame, i);
      else
        recordAll(frame, i, view.translucent);
    }
    if (m_peel) m_peel->record(frame);
  }

  std::span<const std::vector<uint32_t>> parts() const override { return m_parts; }

  void recordPart(Frame& frame, size_t part) override {
    for (size_t i = 0; i < m_maps->views().size(); ++i)
      if (m_maps->views()[i].layer() >= 0) recordAll(frame, i, m_before[part][i]);
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
  /// What one view draws, level by level.
  struct ViewLevels {
    LightLevels levels;
    uint32_t firstLayer = 0;  ///< of the colour map: behind level 0
  };

  void createOpaque(const Context& context) {
    bool opaque = false, perforated = false;
    for (const LightView& view : m_maps->views()) {
      opaque |= !view.opaque.empty();
      perforated |= !view.perforated.empty();
    }
    if (opaque)
      m_opaque =
          context.pipelines.get(m_maps->casterPipeline(context, "shadow map opaque", "", false));
    if (perforated)
      m_perforated = context.pipelines.get(
          m_maps->casterPipeline(context, "shadow map perforated", "common/masked.frag", true));
  }

  void drawOpaque(rhi::CommandList& commands, size_t i) {
    const LightView& view = m_maps->views()[i];
    m_maps->plain(i).draw(commands, m_opaque, view.opaque);
    m_maps->surfaces(i).draw(commands, m_perforated, view.perforated);
  }

  void createTranslucent(const Context& context) {
    m_partition = context.knobs.text("partition");
    m_cap = context.knobs.integer("levels");
    m_format = colourMapFormat(context.knobs);
    m_levelled = m_partition == "levels" || m_partition == "peeled";
    uint32_t layers = std::max(1u, m_maps->layers());
    if (m_levelled) layers = createLevels(context);
    if (layers > 0) {
      m_colour = m_maps->createLike(context, "shadow colour", m_format, layers);
      m_colourPipeline = context.pipelines.get(
          colourPipeline(context, *m_maps, "composited_translucent/colour.frag", m_format));
      if (m_levelled && m_view->steps() > 1) ShadowMaps::clear(context, m_colour);
    }
    if (m_levelled) return;
    m_nearest = m_maps->createLike(context, "translucent depth", m_maps->depthFormat());
    m_nearestPipeline = context.pipelines.get(m_maps->casterPipeline(
        context, "translucent depth", "translucent_shadows/depth.frag", false));
    // Nothing lies in another's shadow: one map serves all (spec 05, "Skip").
    m_inParts = context.plan.runs(Effect::TranslucentOverlap);
    planParts();
  }

  /// Levels and peeled groups of all views at every step; returns the layers that the colour map
  /// needs.
  uint32_t createLevels(const Context& context) {
    std::vector<std::vector<PeelGroup>> steps;
    uint32_t most = 0;
    bool peels = false;
    context.view.alongPath(context.device, [&] {
      most = std::max(most, planLevels());
      std::vector<PeelGroup>& groups = steps.emplace_back();
      for (size_t i = 0; i < m_levels.size(); ++i)
        for (const auto& group : m_levels[i].levels.peeled)
          if (!group.empty()) groups.push_back({.view = i, .instances = group});
      for (PeelGroup& group : groups)
        group.count = LightPeel::countLayers(
            context, *m_maps, group,
            [&](rhi::CommandList& commands, size_t view) { drawOpaque(commands, view); });
      peels |= !groups.empty();
    });
    if (peels) m_peel.emplace(context, *m_maps, std::move(steps), m_cap, m_format);
    return most;
  }

  /// Levels of all views where the camera stands; returns their layers of the colour map.
  uint32_t planLevels() {
    const bool peeled = m_partition == "peeled";
    uint32_t layers = 0;
    m_levels.assign(m_maps->views().size(), {});
    for (size_t i = 0; i < m_levels.size(); ++i) {
      if (m_maps->views()[i].layer() < 0) continue;
      const LightOverlap overlap = lightOverlap(*m_view, m_maps->views()[i]);
      LightLevels& levels = m_levels[i].levels;
      levels = peeled ? onePeeledLevel(overlap) : lightLevels(overlap, m_cap);
      m_levels[i].firstLayer = layers;
      if (!peeled) layers += uint32_t(levels.casters.size());
    }
    return layers;
  }

  void planParts() {
    if (!m_inParts) return;
    m_parts.clear();
    m_before.clear();
    m_partition == "source" ? planMeshes() : planBatches();
  }

  /// The source's partition: each mesh alone, with all whose centres are nearer to the light.
  void planMeshes() {
    const std::vector<LightOrder> orders = lightOrder(*m_context, *m_maps, "centre");
    for (const uint32_t mesh : backToFront(*m_view, m_view->effects().visibleTranslucent)) {
      m_parts.push_back({mesh});
      auto& before = m_before.emplace_back(orders.size());
      for (size_t v = 0; v < orders.size(); ++v) {
        const std::vector<uint32_t>& order = orders[v].instances();
        before[v].assign(order.begin(), std::ranges::find(order, mesh));
      }
    }
  }

  void planBatches() {
    std::vector<LightOverlap> overlaps;
    for (const LightView& view : m_maps->views()) overlaps.push_back(lightOverlap(*m_view, view));
    const auto order = backToFront(*m_view, m_view->effects().visibleTranslucent);
    m_parts = lightBatches(order, overlaps);
    for (const std::vector<uint32_t>& part : m_parts) {
      auto& before = m_before.emplace_back();
      for (const LightOverlap& overlap : overlaps) before.push_back(castersBefore(overlap, part));
    }
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
        behindAll.x = layerBehind(i, uint32_t(m_levels[i].levels.casters.size()));
      else if (const PeelGroup* all = m_levelled ? peelGroup(i, 0) : nullptr)
        behindAll = {0, all->first, all->count, 0};
      table.resize(table.size() + instances, behindAll);
      if (!m_levelled) continue;
      for (const auto& r : m_levels[i].levels.receivers) {
        glm::uvec4& entry = table[table.size() - instances + r.instance];
        entry = {m_colour.id() != rhi::TextureId{} ? layerBehind(i, r.level) : 0, 0, 0, 0};
        const PeelGroup* group = r.peeled ? peelGroup(i, r.level) : nullptr;
        if (group) entry = {entry.x, group->first, group->count, 0};
      }
    }
    return table;
  }

  /// 1 + layer of the colour behind the first `levels` levels; 0 behind none.
  uint32_t layerBehind(size_t view, uint32_t levels) const {
    const uint32_t there = uint32_t(m_levels[view].levels.casters.size());
    return levels == 0 || there == 0 ? 0 : m_levels[view].firstLayer + std::min(levels, there);
  }

  const PeelGroup* peelGroup(size_t view, uint32_t level) const {
    if (!m_peel || level >= m_levels[view].levels.peeled.size()) return nullptr;
    const auto& wanted = m_levels[view].levels.peeled[level];
    for (const PeelGroup& g : m_peel->groups())
      if (g.view == view && g.instances == wanted) return &g;
    return nullptr;
  }

  void recordLevels(Frame& frame, size_t i) {
    if (m_colour.id() == rhi::TextureId{}) return;
    const ViewLevels& view = m_levels[i];
    for (uint32_t level = 0; level < view.levels.casters.size(); ++level) {
      const uint32_t layer = view.firstLayer + level;
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
            m_maps->surfaces(i).draw(commands, m_colourPipeline, view.levels.casters[level]);
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
  rhi::PipelineId m_opaque, m_perforated, m_colourPipeline, m_nearestPipeline;
  std::vector<ViewLevels> m_levels;  ///< by view
  std::optional<LightPeel> m_peel;
  std::vector<std::vector<uint32_t>> m_parts;
  std::vector<std::vector<std::vector<uint32_t>>> m_before;  ///< casters by part and view
  std::vector<rhi::SpecConstant> m_constants;
};

std::vector<KnobInfo> knobs() {
  std::vector<KnobInfo> list = shadowMapKnobs("1");
  list.push_back(colourFormatKnob());
  list.push_back({.name = "partition",
                  .help = "how casters are spread over maps: levels of the overlap graph, peeled "
                          "layers, batches of receivers, or a map for each mesh (seed 000)",
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
        .paper = "seed 000, section 4.2.3; levels, batches and peeling: this project",
        .represents = kShadingEffects |
                      EffectSet{Effect::OpaqueCasters, Effect::PerforatedCasters,
                                Effect::TranslucentCasters, Effect::ColouredTransmission,
                                Effect::TexturedTransmission, Effect::TranslucentReceivers,
                                Effect::TranslucentOverlap},
        .knobs = knobs(),
        .error = "edges move by half a texel; partition source orders by centres, and "
                 "coplanar layers peel as one",
        .drawsInParts = makesMapsBetween}));

}  // namespace
}  // namespace sb
