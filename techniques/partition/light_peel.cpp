#include "techniques/partition/light_peel.h"

#include <algorithm>

#include "shaders/common/shared_slots.h"
#include "techniques/draw/frame/texels.h"

namespace sb {
namespace {

rhi::TextureView layerOf(rhi::TextureId texture, uint32_t layer) {
  return {.texture = texture, .baseMip = 0, .mipCount = 1, .baseLayer = layer, .layerCount = 1};
}

}  // namespace

LightPeel::LightPeel(const Context& context, ShadowMaps& maps,
                     std::vector<std::vector<PeelGroup>> steps, rhi::Format colourFormat)
    : m_view(context.view), m_maps(maps), m_format(colourFormat) {
  uint32_t most = 0;
  bool tails = false;
  for (std::vector<PeelGroup>& groups : steps) {
    most = std::max(most, arrange(groups));
    tails |= std::ranges::any_of(groups, &PeelGroup::tail);
    m_steps.push_back({std::move(groups), {}});
  }
  create(context, most, tails);
  for (Step& step : m_steps) makeDraws(step);
}

LightPeel::LightPeel(const Context& context, ShadowMaps& maps, uint32_t layers,
                     rhi::Format colourFormat)
    : m_view(context.view), m_maps(maps), m_changes(true), m_steps(1), m_format(colourFormat) {
  create(context, layers, true);
}

void LightPeel::use(std::vector<PeelGroup> groups) {
  arrange(groups);
  m_steps.front() = {std::move(groups), {}};
  makeDraws(m_steps.front());
}

uint32_t LightPeel::arrange(std::vector<PeelGroup>& groups) {
  uint32_t layers = 0;
  for (PeelGroup& group : groups) {
    group.tail = group.count > group.cap;
    group.first = layers;
    if (group.tail) group.count = group.cap + 1;
    layers += group.count;
  }
  return layers;
}

void LightPeel::create(const Context& context, uint32_t layers, bool tails) {
  // One layer more than none: what is bound must exist.
  layers = std::max(1u, layers);
  m_depth = m_maps.createLike(context, "peeled depth", rhi::Format::D32Float, layers);
  m_colour = m_maps.createLike(context, "peeled colour", m_format, layers);
  if (std::ranges::any_of(m_steps, [](const Step& step) { return step.groups.empty(); }))
    for (const rhi::Texture* map : {&m_depth, &m_colour}) ShadowMaps::clear(context, *map);
  rhi::GraphicsPipelineDesc desc =
      m_maps.casterPipeline(context, "peeled layer", "light_peel/layer.frag", false);
  desc.depthFormat = rhi::Format::D32Float;
  desc.targets = {{.format = m_format}};
  desc.constants.push_back({16, 1});
  m_first = m_maps.pipelines(context, desc);
  desc.constants.back().bits = 0;
  m_next = m_maps.pipelines(context, desc);
  if (tails) {
    desc = colourPipeline(context, m_maps, "light_peel/tail.frag", m_format);
    desc.depth = {};
    desc.raster.depthBiasConstant = desc.raster.depthBiasSlope = 0;
    desc.depthFormat = rhi::Format::Undefined;
    m_tail = m_maps.pipelines(context, desc);
  }
}

void LightPeel::makeDraws(Step& step) const {
  for (const PeelGroup& group : step.groups)
    for (uint32_t i = 0; i < group.count; ++i) step.draws.push_back(layerDraws(group, i));
}

bool LightPeel::empty() const {
  return !m_changes &&
         std::ranges::all_of(m_steps, [](const Step& step) { return step.groups.empty(); });
}

DrawList LightPeel::layerDraws(const PeelGroup& group, uint32_t layer) const {
  const rhi::TextureView opaque{.texture = m_maps.depth()};
  const uint32_t previous = group.first + layer - 1;
  return DrawList(
      m_view,
      {m_maps.passBlock(group.view),
       rhi::textureAt(TEXTURE_TECHNIQUE, opaque, m_maps.pointSampler()),
       rhi::textureAt(TEXTURE_TECHNIQUE + 1, layer > 0 ? layerOf(m_depth, previous) : opaque,
                      m_maps.pointSampler()),
       rhi::textureAt(TEXTURE_TECHNIQUE + 2, layer > 0 ? layerOf(m_colour, previous) : opaque,
                      m_maps.pointSampler())},
      true);
}

uint32_t LightPeel::countLayers(const Context& context, ShadowMaps& maps, const PeelGroup& group,
                                const DrawOpaque& drawOpaque) {
  if (group.instances.empty()) return 0;
  rhi::Texture counts = maps.createLike(context, "layers counted", rhi::Format::RGBA16Float, 1);
  rhi::GraphicsPipelineDesc desc =
      maps.casterPipeline(context, "layers counted", "light_peel/count.frag", false);
  desc.depth = {};
  desc.depthFormat = rhi::Format::Undefined;
  desc.targets = {
      {.format = rhi::Format::RGBA16Float,
       .blend = {
           .enabled = true, .dstColor = rhi::BlendFactor::One, .dstAlpha = rhi::BlendFactor::One}}};
  const rhi::PipelineId pipeline = context.pipeline(desc);
  DrawList draws(context.view,
                 {maps.passBlock(group.view),
                  rhi::textureAt(TEXTURE_TECHNIQUE, maps.depth(), maps.pointSampler())},
                 true);
  const rhi::ColorAttachment target{.view = {.texture = counts}};
  const rhi::ResourceUse reads[] = {rhi::use(maps.depth().id(), rhi::Access::Sampled)};
  rhi::FrameScope frame(context.device);
  rhi::CommandList& commands = frame.commands();
  {
    rhi::PassScope pass = commands.beginPass(
        {.label = "shadow map", .depth = maps.depthAttachment(maps.views()[group.view])});
    drawOpaque(commands, group.view);
  }
  {
    rhi::PassScope pass = commands.beginPass(
        {.label = "layers counted", .colors = std::span(&target, 1), .reads = reads});
    draws.draw(commands, pipeline, group.instances);
  }
  frame.endAndWait();
  float most = 0;  // exact up to 2048
  for (const float count : halfToFloat(context.device.read(counts))) most = std::max(most, count);
  return uint32_t(most);
}

void LightPeel::record(Frame& frame) {
  for (const PeelGroup& group : groups()) {
    for (uint32_t i = 0; i < group.count; ++i) recordLayer(frame, group, i);
    if (group.tail) recordTail(frame, group);
  }
}

void LightPeel::recordLayer(Frame& frame, const PeelGroup& group, uint32_t layer) {
  const uint32_t at = group.first + layer;
  const rhi::ColorAttachment colour{.view = layerOf(m_colour, at), .clear = {1, 1, 1, 1}};
  std::vector<rhi::ResourceUse> reads = {rhi::use(m_maps.depth().id(), rhi::Access::Sampled)};
  if (layer > 0) {
    reads.push_back(rhi::use(layerOf(m_depth, at - 1), rhi::Access::Sampled));
    reads.push_back(rhi::use(layerOf(m_colour, at - 1), rhi::Access::Sampled));
  }
  frame.pass({.label = "peeled layer",
              .colors = std::span(&colour, 1),
              .depth = rhi::DepthAttachment{.view = layerOf(m_depth, at), .clearDepth = 0},
              .reads = reads},
             PassGroup::Shadow, [&](rhi::CommandList& commands) {
               m_steps[m_step].draws[at].draw(commands, layer > 0 ? m_next : m_first,
                                              group.instances);
             });
}

void LightPeel::recordTail(Frame& frame, const PeelGroup& group) {
  const uint32_t at = group.first + group.count - 1;
  frame.commands().copy(layerOf(m_colour, at - 1), layerOf(m_colour, at));
  const rhi::ColorAttachment colour{.view = layerOf(m_colour, at), .load = rhi::LoadOp::Load};
  const rhi::ResourceUse reads[] = {rhi::use(m_maps.depth().id(), rhi::Access::Sampled),
                                    rhi::use(layerOf(m_depth, at - 1), rhi::Access::Sampled)};
  frame.pass({.label = "peeled tail", .colors = std::span(&colour, 1), .reads = reads},
             PassGroup::Shadow, [&](rhi::CommandList& commands) {
               m_steps[m_step].draws[at].draw(commands, m_tail, group.instances);
             });
}

}  // namespace sb
