#include <algorithm>

#include "techniques/partition/colour_maps.h"
#include "techniques/partition/view_levels.h"

namespace sb {
namespace {

class LevelMaps final : public ColourMaps {
 public:
  explicit LevelMaps(const ColourMapInputs& in)
      : m_view(in.context.view),
        m_shadows(in.maps),
        m_onlyPeeled(in.context.knobs.is("partition", "peeled")),
        m_cap(in.context.knobs.integer("levels")) {
    const rhi::Format format = colourMapFormat(in.context.knobs);
    const uint32_t layers =
        m_view.isFree() ? planForFreeCamera(in, format) : planAlongPath(in, format);
    if (layers == 0) return;
    m_colour = m_shadows.createLike(in.context, "shadow colour", format, layers);
    m_pipeline = in.context.pipeline(
        colourPipeline(in.context, m_shadows, "composited_translucent/colour.frag", format));
    if (!m_view.stands()) ShadowMaps::clear(in.context, m_colour);
  }

  void moved() override {
    plan();
    if (!m_peel) return;
    if (m_view.isFree())
      m_peel->use(groupsOfFreeCamera());
    else
      m_peel->use(m_view.step());
  }

  void record(Frame& frame, size_t view) override {
    if (!hasColour()) return;
    const std::vector<std::vector<uint32_t>>& casters = m_levels.of(view).casters;
    for (uint32_t level = 0; level < casters.size(); ++level) {
      const uint32_t layer = m_levels.layer(view, level);
      if (level > 0) frame.commands().copy(layerOf(layer - 1), layerOf(layer));
      recordColourPass(
          frame, m_shadows, m_shadows.views()[view], m_colour, layer,
          [&](rhi::CommandList& commands) {
            m_shadows.surfaces(view).draw(commands, m_pipeline, casters[level]);
          },
          level > 0 ? rhi::LoadOp::Load : rhi::LoadOp::Clear);
    }
  }

  void recordLast(Frame& frame) override {
    if (m_peel) m_peel->record(frame);
  }

  glm::uvec4 behindAll(size_t view) const override {
    const auto levels = uint32_t(m_levels.of(view).casters.size());
    if (hasColour()) return {m_levels.layerBehind(view, levels), 0, 0, 0};
    const PeelGroup* all = m_levels.group(m_peel, view, 0);
    return all ? glm::uvec4(0, all->first, all->count, 0) : glm::uvec4(0);
  }

  void addReceivers(size_t view, std::span<glm::uvec4> entries) const override {
    for (const auto& r : m_levels.of(view).receivers) {
      const uint32_t layer = hasColour() ? m_levels.layerBehind(view, r.level) : 0;
      const PeelGroup* group = r.peeled ? m_levels.group(m_peel, view, r.level) : nullptr;
      entries[r.instance] =
          group ? glm::uvec4(layer, group->first, group->count, 0) : glm::uvec4(layer, 0, 0, 0);
    }
  }

  Maps maps() const override {
    Maps maps{.colour = m_colour, .nearest = {}, .peeledDepth = {}, .peeledColour = {}};
    if (m_peel) maps.peeledDepth = m_peel->depth(), maps.peeledColour = m_peel->colour();
    return maps;
  }
  bool peels() const override { return m_peel && !m_peel->empty(); }

 private:
  bool hasColour() const { return m_colour.id() != rhi::TextureId{}; }
  rhi::TextureView layerOf(uint32_t layer) const {
    return {.texture = m_colour, .baseMip = 0, .mipCount = 1, .baseLayer = layer, .layerCount = 1};
  }

  void plan() { m_levels.plan(m_view, m_shadows, m_onlyPeeled, m_cap); }

  /// Levels and peeled groups of all views at every step; returns the layers that the colour map
  /// needs.
  uint32_t planAlongPath(const ColourMapInputs& in, rhi::Format format) {
    std::vector<std::vector<PeelGroup>> steps;
    uint32_t most = 0;
    in.context.view.alongPath(in.context.device, [&] {
      plan();
      most = std::max(most, m_levels.layers());
      for (PeelGroup& group : steps.emplace_back(m_levels.groups())) {
        group.cap = m_cap;
        group.count = countLayers(in, group);
      }
    });
    if (std::ranges::any_of(steps, [](const auto& groups) { return !groups.empty(); }))
      m_peel.emplace(in.context, m_shadows, std::move(steps), format);
    return most;
  }

  /// The same for a camera that is set freely. Each view may have as many levels as casters; of a
  /// group no more layers are peeled than all casters of its view have together, seen from the
  /// light over the whole scene. One more that a finer map finds is in the tail.
  uint32_t planForFreeCamera(const ColourMapInputs& in, rhi::Format format) {
    m_peelCaps.assign(m_shadows.views().size(), 1);
    in.context.view.alongPath(in.context.device, [&] {
      for (size_t i = 0; i < m_shadows.views().size(); ++i) {
        const PeelGroup all{.view = i, .instances = m_shadows.views()[i].translucent};
        m_peelCaps[i] = std::max(m_peelCaps[i], std::min(countLayers(in, all), m_cap));
      }
    });
    uint32_t levels = 0, peeled = 0;
    for (size_t i = 0; i < m_shadows.views().size(); ++i) {
      const std::vector<uint32_t>& casters = m_shadows.views()[i].translucent;
      const uint32_t most = std::min(m_cap, uint32_t(casters.size()));
      if (!m_onlyPeeled) levels += most;
      const uint32_t groups = m_onlyPeeled ? std::min(1u, most) : most;
      peeled += std::min(groups * (m_peelCaps[i] + 1), triangles(casters));
    }
    m_peel.emplace(in.context, m_shadows, peeled, format);
    moved();
    return levels;
  }

  std::vector<PeelGroup> groupsOfFreeCamera() const {
    std::vector<PeelGroup> groups = m_levels.groups();
    for (PeelGroup& group : groups) {
      group.cap = m_peelCaps[group.view];
      group.count = triangles(group.instances);
    }
    return groups;
  }

  uint32_t triangles(std::span<const uint32_t> instances) const {
    const Scene& scene = m_view.scene();
    uint32_t count = 0;
    for (const uint32_t i : instances)
      count += scene.meshes[scene.instances[i].mesh].triangleCount();
    return count;
  }

  uint32_t countLayers(const ColourMapInputs& in, const PeelGroup& group) {
    return LightPeel::countLayers(
        in.context, m_shadows, group,
        [&](rhi::CommandList& commands, size_t view) { in.opaque.draw(commands, view); });
  }

  const SceneView& m_view;
  ShadowMaps& m_shadows;
  bool m_onlyPeeled;
  uint32_t m_cap;
  ViewLevels m_levels;
  std::optional<LightPeel> m_peel;
  std::vector<uint32_t> m_peelCaps;  ///< by view, of a camera that is set freely
  rhi::Texture m_colour;
  rhi::PipelineId m_pipeline;
};

}  // namespace

std::unique_ptr<ColourMaps> makeLevelMaps(const ColourMapInputs& inputs) {
  return std::make_unique<LevelMaps>(inputs);
}

}  // namespace sb
