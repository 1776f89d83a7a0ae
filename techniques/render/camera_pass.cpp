#include "techniques/render/camera_pass.h"

#include <algorithm>

#include "shaders/common/shared_slots.h"
#include "techniques/render/frame_order.h"

namespace sb {

CameraPass::CameraPass(const Context& context, CameraPassDesc desc)
    : m_context(context), m_desc(std::move(desc)) {
  const auto [width, height] = context.view.size();
  using U = rhi::TextureUse;
  m_color = context.device.createTexture({.label = "camera colour",
                                          .format = kColorFormat,
                                          .width = width,
                                          .height = height,
                                          .use = U::ColorTarget | U::Sampled | U::CopySource});
  m_depth = context.device.createTexture({.label = "camera depth",
                                          .format = depthFormat(),
                                          .width = width,
                                          .height = height,
                                          .use = U::DepthTarget | U::Sampled | U::CopySource});
  // Every pipeline may read the triangle order; only sorted triangles have one of their own.
  m_noOrder = context.device.createBuffer(
      {.label = "view triangle order", .size = 16, .use = rhi::BufferUse::Storage});
  if (coplanar()) {
    m_depthSampler = context.device.createSampler(
        {.label = "opaque depth sampler", .filter = rhi::Filter::Nearest});
    const rhi::Binding depth = opaqueDepth();
    m_translucentDraws = drawListWith({&depth, 1});
  }
  m_drawList = drawListWith({});

  m_opaque = OpaqueSurfaces(context, *this);
  if (m_desc.transparency && context.plan.runs(Effect::CameraTransparency)) {
    m_transparency = m_desc.transparency->make();
    m_transparency->prepare(context, *this);
  }
}

void CameraPass::moved(Frame& frame) {
  m_opaque.refill(*this);
  if (m_transparency) m_transparency->moved(frame, *this);
}

const std::string& CameraPass::folder(Receivers receivers) const {
  const TransparencyEntry* transparency = m_desc.transparency;
  const bool lit = receivers == Receivers::Translucent && byLayer() &&
                   !(transparency && transparency->info.handsOutLayers);
  return lit ? baselineTechnique().info.folder : m_desc.folder;
}

std::string CameraPass::shaded(Receivers receivers, const std::string& transparencyFolder,
                               const std::string& pass) const {
  std::string name = folder(receivers);
  if (!transparencyFolder.empty()) name += "+" + transparencyFolder;
  // As shaders are named (backends/shader/collect.h).
  if (m_desc.lightsFolder != "all_lights") name += "@" + m_desc.lightsFolder;
  return name + "/" + pass;
}

rhi::GraphicsPipelineDesc CameraPass::surfacePipeline(const std::string& label,
                                                      const std::string& fragment,
                                                      bool masked) const {
  rhi::GraphicsPipelineDesc desc{.label = m_desc.folder + " " + label,
                                 .vertex = &m_context.shaders.get("common/surface.vert"),
                                 .fragment = &m_context.shaders.get(fragment),
                                 .vertexBuffers = GpuScene::vertexLayout(true),
                                 .attributes = GpuScene::vertexAttributes(true),
                                 .depth = {.test = true, .write = true, .compare = kNearer},
                                 .targets = {{.format = kColorFormat}},
                                 .depthFormat = depthFormat()};
  std::vector<rhi::SpecConstant> constants = {{0, m_context.view.gpu().textured()},
                                              {1, m_context.plan.runs(Effect::NormalMaps)},
                                              {2, masked},
                                              {4, coplanar()}};
  constants.insert(constants.end(), m_desc.inputs.constants.begin(), m_desc.inputs.constants.end());
  desc.constants = declaredConstants({desc.vertex, desc.fragment}, constants);
  return desc;
}

rhi::GraphicsPipelineDesc CameraPass::translucentPipeline(
    const std::string& transparencyFolder) const {
  rhi::GraphicsPipelineDesc desc = surfacePipeline(
      "translucent", shaded(Receivers::Translucent, transparencyFolder, "translucent.frag"), false);
  desc.depth = {.test = true, .write = false, .compare = kNearerOrEqual};
  return desc;
}

rhi::GraphicsPipelineDesc CameraPass::unshadedPipeline(const std::string& fragment) const {
  rhi::GraphicsPipelineDesc desc = surfacePipeline("", fragment, false);
  desc.label = fragment;
  desc.depth = {};
  desc.targets = {};
  desc.depthFormat = rhi::Format::Undefined;
  return desc;
}

rhi::GraphicsPipelineDesc CameraPass::compositePipeline(const std::string& fragment) const {
  return {.label = fragment,
          .vertex = &m_context.shaders.get("common/fullscreen.vert"),
          .fragment = &m_context.shaders.get(fragment),
          .targets = {{.format = kColorFormat,
                       .blend = {.enabled = true,
                                 .dstColor = rhi::BlendFactor::SrcAlpha,
                                 .srcAlpha = rhi::BlendFactor::Zero,
                                 .dstAlpha = rhi::BlendFactor::One}}}};
}

rhi::GraphicsPipelineDesc CameraPass::colouredCompositePipeline(const std::string& fragment) const {
  rhi::GraphicsPipelineDesc desc = compositePipeline(fragment);
  desc.targets.front().blend.dstColor = rhi::BlendFactor::Src1Color;
  return desc;
}

DrawList CameraPass::drawListWith(std::span<const rhi::Binding> extra) const {
  std::vector<rhi::Binding> all = m_desc.inputs.bindings;
  all.push_back(rhi::storageAt(STORAGE_TRIANGLE_ORDER, m_noOrder));
  all.insert(all.end(), extra.begin(), extra.end());
  return DrawList(m_context.view, std::move(all), true);
}

std::vector<std::string> CameraPass::warnings() {
  return m_transparency ? m_transparency->warnings() : std::vector<std::string>();
}

void CameraPass::recordLayer(Frame& frame, const ReceiverLayer& layer,
                             const std::function<void()>& depth,
                             const std::function<void()>& surfaces) const {
  const auto begin = [&] { m_context.transients.begin(frame.commands()); };
  sb::recordLayer(frame, m_desc.byLayer, layer,
                  {.depth = [&] { depth(), begin(); }, .surfaces = [&] { begin(), surfaces(); }});
}

void CameraPass::recordOpaque(Frame& frame) {
  recordLayer(
      frame, {.depth = m_depth, .index = 0}, [&] { recordDepth(frame); },
      [&] { recordShaded(frame); });
}

void CameraPass::recordDepth(Frame& frame) {
  // It exists for shadows alone.
  frame.pass({.label = "depth prepass",
              .depth = rhi::DepthAttachment{.view = {.texture = m_depth}, .clearDepth = kFarDepth}},
             PassGroup::Shadow,
             [&](rhi::CommandList& commands) { m_opaque.drawDepth(commands, m_drawList); });
}

void CameraPass::recordShaded(Frame& frame) {
  const glm::vec3 background = m_context.view.scene().background;
  const rhi::ColorAttachment color{.view = {.texture = m_color},
                                   .clear = {background.r, background.g, background.b, 1}};
  rhi::DepthAttachment depth{.view = {.texture = m_depth}, .clearDepth = kFarDepth};
  if (m_desc.byLayer) {
    depth.load = rhi::LoadOp::Load;
    depth.readOnly = true;
  }
  frame.pass({.label = "opaque",
              .colors = std::span(&color, 1),
              .depth = depth,
              .reads = m_desc.inputs.reads},
             PassGroup::Scene,
             [&](rhi::CommandList& commands) { m_opaque.drawShaded(commands, m_drawList); });
}

void CameraPass::recordTranslucent(Frame& frame) {
  // A step or a camera that shows none, though others do.
  if (!view().stands() && translucent().empty()) return;
  if (m_transparency) m_transparency->record(frame, *this);
}

void CameraPass::recordTranslucent(Frame& frame, std::span<const uint32_t> part) {
  if (m_transparency) m_transparency->recordPart(frame, *this, part);
}

void CameraPass::translucentPass(Frame& frame, const std::string& label,
                                 const std::function<void(rhi::CommandList&)>& body) {
  const rhi::ColorAttachment color{.view = {.texture = m_color}, .load = rhi::LoadOp::Load};
  if (coplanar()) {
    const rhi::ResourceUse read = rhi::use(m_depth.id(), rhi::Access::Sampled);
    surfacePass(frame, {.label = label, .colors = std::span(&color, 1), .reads = {&read, 1}}, body);
    return;
  }
  frame.pass({.label = label,
              .colors = std::span(&color, 1),
              .depth =
                  rhi::DepthAttachment{
                      .view = {.texture = m_depth}, .load = rhi::LoadOp::Load, .readOnly = true},
              .reads = m_desc.inputs.reads},
             PassGroup::Scene, body);
}

void CameraPass::surfacePass(Frame& frame, rhi::PassDesc desc,
                             const std::function<void(rhi::CommandList&)>& body) {
  std::vector<rhi::ResourceUse> reads(desc.reads.begin(), desc.reads.end());
  reads.insert(reads.end(), m_desc.inputs.reads.begin(), m_desc.inputs.reads.end());
  desc.reads = reads;
  frame.pass(desc, PassGroup::Scene, body);
}

void CameraPass::compositePass(Frame& frame, const std::string& label,
                               std::span<const rhi::ResourceUse> reads,
                               const std::function<void(rhi::CommandList&)>& body) {
  const rhi::ColorAttachment color{.view = {.texture = m_color}, .load = rhi::LoadOp::Load};
  frame.pass({.label = label, .colors = std::span(&color, 1), .reads = reads}, PassGroup::Scene,
             body);
}

}  // namespace sb
