// Composited translucent shadows (Modisett 2023, section 4.2.3) and better partitions of it; spec
// 05. Every translucent receiver reads the colour behind those casters alone that lie before it.
// Right at every receiver up to texels and the rounding of the colour; no noise.
//   partition=levels   one map a level of the light-space overlap graph, each caster drawn once;
//                      what has no order (cycles, surfaces that shadow themselves) is peeled on
//                      its level
//   partition=peeled   layers peeled from the light: exact per texel, a pass a layer
//   partition=batches  one map, made anew for each run of receivers that may share it
//   partition=source   one map, made anew for each translucent mesh: Modisett's, quadratic
// The last two make maps between the camera's draws, and so need sorted meshes; surfaces that are
// opaque to the camera but not to light read the map of all casters there.
#include "shaders/common/shared_slots.h"
#include "techniques/partition/colour_maps.h"
#include "techniques/render/registry.h"

namespace sb {
namespace {

bool makesMapsBetween(const Knobs& knobs) {
  return knobs.is("partition", "source") || knobs.is("partition", "batches");
}

class CompositedTranslucent final : public ShadowTechnique {
 public:
  void prepare(const Context& context) override {
    m_view = &context.view;
    m_maps.emplace(context, 0.0f, DepthShape{.reachTranslucent = true});
    m_opaque.emplace(context, *m_maps);
    const bool translucent = context.plan.runs(Effect::TranslucentCasters);
    const ColourMapInputs inputs{context, *m_maps, *m_opaque};
    if (translucent)
      m_colours = makesMapsBetween(context.knobs) ? makePartMaps(inputs) : makeLevelMaps(inputs);
    if (m_colours) m_read = m_colours->maps();
    m_constants = m_maps->constants(context.knobs);
    m_constants.push_back({19, translucent});
    m_constants.push_back({20, m_colours && m_colours->peels()});
    m_constants.push_back({21, m_read.nearest != rhi::TextureId{}});
    createReceivers(context);
  }

  void moved(Frame& frame) override {
    if (m_colours) m_colours->moved();
    const std::vector<glm::uvec4> table = receiverTable();
    frame.commands().write(m_receivers, 0, std::as_bytes(std::span(table)));
  }

  void record(Frame& frame) override {
    for (size_t i = 0; i < m_maps->views().size(); ++i) {
      const LightView& view = m_maps->views()[i];
      if (view.layer < 0) continue;
      frame.pass({.label = "shadow map", .depth = m_maps->depthAttachment(view)}, PassGroup::Shadow,
                 [&](rhi::CommandList& commands) { m_opaque->draw(commands, i); });
      if (m_colours) m_colours->record(frame, i);
    }
    if (m_colours) m_colours->recordLast(frame);
  }

  std::span<const std::vector<uint32_t>> parts() const override {
    return m_colours ? m_colours->parts() : std::span<const std::vector<uint32_t>>{};
  }
  void recordPart(Frame& frame, size_t part) override { m_colours->recordPart(frame, part); }

  VisibilityInputs inputs() const override {
    VisibilityInputs inputs{.bindings = {rhi::storageAt(STORAGE_TECHNIQUE, m_receivers)},
                            .reads = {},
                            .constants = m_constants};
    const rhi::TextureId opaque = m_maps->depth();
    const rhi::TextureId maps[] = {opaque, m_read.colour, m_read.nearest, m_read.peeledDepth,
                                   m_read.peeledColour};
    for (uint32_t slot = 0; slot < std::size(maps); ++slot) {
      const bool read = maps[slot] != rhi::TextureId{};
      inputs.bindings.push_back(rhi::textureAt(TEXTURE_TECHNIQUE + slot, read ? maps[slot] : opaque,
                                               m_maps->pointSampler()));
      if (read) inputs.reads.push_back(rhi::use(maps[slot], rhi::Access::Sampled));
    }
    return inputs;
  }

  std::vector<std::pair<std::string, rhi::TextureId>> maps() const override {
    std::vector<std::pair<std::string, rhi::TextureId>> list = {{"depth", m_maps->depth()}};
    for (const auto& [name, map] :
         {std::pair("colours", m_read.colour), std::pair("translucent depth", m_read.nearest),
          std::pair("peeled depth", m_read.peeledDepth),
          std::pair("peeled colour", m_read.peeledColour)})
      if (map != rhi::TextureId{}) list.emplace_back(name, map);
    return list;
  }

  LookupReach reach(uint32_t light) const override { return m_maps->reach(light); }

 private:
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
    const size_t instances = m_view->scene().instances.size();
    std::vector<glm::uvec4> table = {glm::uvec4(uint32_t(instances), 0, 0, 0)};
    for (size_t i = 0; i < m_maps->views().size(); ++i) {
      table.resize(table.size() + instances, m_colours ? m_colours->behindAll(i) : glm::uvec4(0));
      if (m_colours) m_colours->addReceivers(i, std::span(table).last(instances));
    }
    return table;
  }

  const SceneView* m_view = nullptr;
  std::optional<ShadowMaps> m_maps;
  std::optional<OpaqueCasters> m_opaque;
  std::unique_ptr<ColourMaps> m_colours;  ///< null: the scene calls for none
  ColourMaps::Maps m_read;
  rhi::Buffer m_receivers;
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
