#include "techniques/volumes/wedges/soft_shadows.h"

#include "shaders/common/shared_slots.h"
#include "techniques/render/screen_targets.h"
#include "techniques/volumes/wedges/wedge_halves.h"
#include "techniques/volumes/wedges/wedge_loops.h"
#include "techniques/volumes/wedges/wedge_sums.h"

namespace sb {

std::unique_ptr<SoftShadows> SoftShadows::make(const Context& context, const LightWedges& wedges) {
  if (context.knobs.is("combine", "loop")) return std::make_unique<WedgeLoops>(context, wedges);
  if (context.knobs.is("combine", "split")) return std::make_unique<WedgeHalves>(context, wedges);
  return std::make_unique<WedgeSums>(context, wedges);
}

SoftShadows::SoftShadows(const Context& context, const LightWedges& wedges)
    : m_context(context),
      m_wedges(wedges),
      m_sampler(context.device.createSampler(
          {.label = "penumbra sampler", .filter = rhi::Filter::Nearest})) {
  if (context.knobs.is("coverage", "lut"))
    m_tables = coverageTables(context.device, context.knobs.integer("lut"));
}

std::vector<rhi::Binding> SoftShadows::bindings(const ReceiverLayer& layer, size_t light) const {
  std::vector<rhi::Binding> bindings = m_wedges.bindings(light);
  bindings.push_back(rhi::textureAt(TEXTURE_TECHNIQUE, layer.depth, m_sampler));
  if (m_tables) {
    bindings.push_back(rhi::textureAt(TEXTURE_TECHNIQUE + 2, m_tables->oneSide, m_tables->sampler));
    bindings.push_back(
        rhi::textureAt(TEXTURE_TECHNIQUE + 3, m_tables->bothSides, m_tables->sampler));
  }
  return bindings;
}

const rhi::ShaderCode* SoftShadows::shader(const std::string& name) const {
  return &m_context.shaders.get("penumbra_wedge/" + name + (m_tables ? "_tables.frag" : ".frag"));
}

rhi::Format SoftShadows::format(rhi::Format full, rhi::Format half, rhi::Format bytes) const {
  const Knobs& knobs = m_context.knobs;
  return knobs.is("format", "rgba8") ? bytes : knobs.is("format", "r16f") ? half : full;
}

rhi::GraphicsPipelineDesc SoftShadows::wedgePipeline(const rhi::ShaderCode* fragment,
                                                     rhi::Format format) const {
  return {.label = "penumbra wedges",
          .vertex = &m_context.shaders.get("penumbra_wedge/wedge.vert"),
          .fragment = fragment,
          // Backs alone: what lies in a wedge lies before them, wherever the eye is.
          .raster = {.cull = rhi::CullMode::Front, .depthClamp = true},
          .depth = {.test = true, .compare = rhi::CompareOp::LessOrEqual},
          .targets = {{.format = format, .blend = kBlendAdd}},
          .depthFormat = VolumeCounter::kDepthFormat};
}

void SoftShadows::recordSum(const SoftLight& light, rhi::TextureId target,
                            const std::function<void(rhi::CommandList&)>& body) const {
  const rhi::ColorAttachment sum{.view = {.texture = target}};
  const rhi::ResourceUse depth = rhi::use(light.layer.depth, rhi::Access::Sampled);
  light.frame.pass({.label = "penumbra wedges",
                    .colors = std::span(&sum, 1),
                    .depth = rhi::DepthAttachment{.view = {.texture = light.layer.depth},
                                                  .load = rhi::LoadOp::Load,
                                                  .readOnly = true},
                    .reads = {&depth, 1}},
                   PassGroup::Shadow, body);
}

void SoftShadows::drawWedges(rhi::CommandList& commands, rhi::PipelineId pipeline,
                             const SoftLight& light, const WedgeRange& wedges) const {
  if (wedges.count == 0) return;
  const std::vector<rhi::Binding> all = bindings(light.layer, light.number);
  commands.draw(
      {.pipeline = pipeline, .bindings = all, .scissor = light.light.scissor},
      {.vertexCount = WEDGE_VERTICES * wedges.count, .firstVertex = WEDGE_VERTICES * wedges.first});
}

}  // namespace sb
