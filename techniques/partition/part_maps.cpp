#include <algorithm>

#include "techniques/partition/colour_maps.h"
#include "techniques/partition/receiver_parts.h"

namespace sb {
namespace {

class PartMaps final : public ColourMaps {
 public:
  explicit PartMaps(const ColourMapInputs& in)
      : m_context(in.context),
        m_shadows(in.maps),
        m_ofMeshes(in.context.knobs.is("partition", "source")),
        // Nothing lies in another's shadow: one map serves all (spec 05, "Skip").
        m_inParts(in.context.plan.runs(Effect::TranslucentOverlap)) {
    const rhi::Format format = colourMapFormat(in.context.knobs);
    m_colour =
        m_shadows.createLike(in.context, "shadow colour", format, std::max(1u, m_shadows.layers()));
    m_colourPipeline = in.context.pipeline(
        colourPipeline(in.context, m_shadows, "composited_translucent/colour.frag", format));
    m_nearest = m_shadows.createLike(in.context, "translucent depth", m_shadows.depthFormat());
    m_nearestPipeline = m_shadows.pipelines(
        in.context, m_shadows.casterPipeline(in.context, "translucent depth",
                                             "translucent_shadows/depth.frag", false));
    moved();
  }

  void moved() override {
    if (m_inParts)
      m_parts =
          m_ofMeshes ? meshParts(m_context, m_shadows) : batchParts(m_context.view, m_shadows);
  }

  void record(Frame& frame, size_t view) override {
    recordMap(frame, view, m_shadows.views()[view].translucent);
  }

  std::span<const std::vector<uint32_t>> parts() const override { return m_parts.receivers; }

  void recordPart(Frame& frame, size_t part) override {
    for (size_t i = 0; i < m_shadows.views().size(); ++i)
      if (m_shadows.views()[i].layer >= 0) recordMap(frame, i, m_parts.casters[part][i]);
  }

  glm::uvec4 behindAll(size_t view) const override {
    return {1 + uint32_t(std::max(0, m_shadows.views()[view].layer)), 0, 0, 0};
  }

  Maps maps() const override {
    return {.colour = m_colour, .nearest = m_nearest, .peeledDepth = {}, .peeledColour = {}};
  }

 private:
  /// Nearest depth of some casters of a view and the colour behind them, as in technique 02.
  void recordMap(Frame& frame, size_t i, const std::vector<uint32_t>& casters) {
    const LightView& view = m_shadows.views()[i];
    rhi::DepthAttachment depth = m_shadows.depthAttachment(view);
    depth.view.texture = m_nearest;
    frame.pass({.label = "translucent depth", .depth = depth}, PassGroup::Shadow,
               [&](rhi::CommandList& commands) {
                 m_shadows.surfaces(i).draw(commands, m_nearestPipeline, casters);
               });
    recordColourPass(frame, m_shadows, view, m_colour, uint32_t(view.layer),
                     [&](rhi::CommandList& commands) {
                       m_shadows.surfaces(i).draw(commands, m_colourPipeline, casters);
                     });
  }

  const Context m_context;
  ShadowMaps& m_shadows;
  bool m_ofMeshes;
  bool m_inParts;
  ReceiverParts m_parts;
  rhi::Texture m_colour, m_nearest;
  CasterPipelines m_nearestPipeline;
  rhi::PipelineId m_colourPipeline;
};

}  // namespace

std::unique_ptr<ColourMaps> makePartMaps(const ColourMapInputs& inputs) {
  return std::make_unique<PartMaps>(inputs);
}

}  // namespace sb
