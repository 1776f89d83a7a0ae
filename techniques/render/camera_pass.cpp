#include "techniques/render/camera_pass.h"

#include <algorithm>

#include "shaders/common/shared_slots.h"

namespace sb {

CameraPass::CameraPass(const Context& context, std::string folder, VisibilityInputs inputs,
                       const TransparencyEntry* transparency)
    : m_context(context), m_folder(std::move(folder)), m_inputs(std::move(inputs)) {
  const auto [width, height] = context.view.size();
  using U = rhi::TextureUse;
  m_color = context.device.createTexture({.label = "camera colour",
                                          .format = kColorFormat,
                                          .width = width,
                                          .height = height,
                                          .use = U::ColorTarget | U::Sampled | U::CopySource});
  m_depth = context.device.createTexture({.label = "camera depth",
                                          .format = kDepthFormat,
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

  fillBuckets();
  for (Bucket& bucket : m_buckets) {
    rhi::GraphicsPipelineDesc desc =
        surfacePipeline(bucket.masked ? "masked" : "opaque", "forward.frag", bucket.masked);
    desc.raster.cull = bucket.doubleSided ? rhi::CullMode::None : rhi::CullMode::Back;
    bucket.pipeline = m_opaque[{bucket.masked, bucket.doubleSided}] = context.pipeline(desc);
  }
  if (transparency && context.plan.runs(Effect::CameraTransparency)) {
    m_transparency = transparency->make();
    m_transparency->prepare(context, *this);
  }
}

void CameraPass::fillBuckets() {
  m_buckets.clear();
  const Scene& scene = m_context.view.scene();
  for (uint32_t i : m_context.view.effects().visibleOpaque) {
    const Material& material = scene.materials[scene.meshes[scene.instances[i].mesh].material];
    const bool masked = material.alphaMode == AlphaMode::Mask;
    auto bucket = std::ranges::find_if(m_buckets, [&](const Bucket& b) {
      return b.masked == masked && b.doubleSided == material.doubleSided;
    });
    if (bucket == m_buckets.end())
      bucket = m_buckets.insert(bucket, {.masked = masked,
                                         .doubleSided = material.doubleSided,
                                         .instances = {},
                                         .pipeline = m_opaque[{masked, material.doubleSided}]});
    bucket->instances.push_back(i);
  }
}

void CameraPass::cameraMoved(Frame& frame) {
  fillBuckets();
  if (m_transparency) m_transparency->cameraMoved(frame, *this);
}

rhi::GraphicsPipelineDesc CameraPass::surfacePipeline(const std::string& label,
                                                      const std::string& fragment,
                                                      bool masked) const {
  rhi::GraphicsPipelineDesc desc{
      .label = m_folder + " " + label,
      .vertex = &m_context.shaders.get("common/surface.vert"),
      .fragment = &m_context.shaders.get(m_folder + "/" + fragment),
      .vertexBuffers = GpuScene::vertexLayout(true),
      .attributes = GpuScene::vertexAttributes(true),
      .depth = {.test = true, .write = true, .compare = rhi::CompareOp::Less},
      .targets = {{.format = kColorFormat}},
      .depthFormat = kDepthFormat};
  std::vector<rhi::SpecConstant> constants = {
      {0, m_context.view.gpu().textured()},
      {1, m_context.plan.runs(Effect::NormalMaps)},
      {2, masked},
      {4, !m_context.view.gpu().coplanar().empty()}};
  constants.insert(constants.end(), m_inputs.constants.begin(), m_inputs.constants.end());
  desc.constants = declaredConstants({desc.vertex, desc.fragment}, constants);
  return desc;
}

rhi::GraphicsPipelineDesc CameraPass::translucentPipeline(
    const std::string& transparencyFolder) const {
  rhi::GraphicsPipelineDesc desc = surfacePipeline("translucent", "forward.frag", false);
  desc.fragment = &m_context.shaders.get(m_folder + "+" + transparencyFolder + "/translucent.frag");
  desc.depth = {.test = true, .write = false, .compare = rhi::CompareOp::LessOrEqual};
  return desc;
}

rhi::GraphicsPipelineDesc CameraPass::unshadedPipeline(const std::string& fragment) const {
  rhi::GraphicsPipelineDesc desc = surfacePipeline("translucent", "forward.frag", false);
  desc.label = fragment;
  desc.fragment = &m_context.shaders.get(fragment);
  desc.constants =
      declaredConstants({desc.vertex, desc.fragment},
                        {{0, m_context.view.gpu().textured()},
                         {4, !m_context.view.gpu().coplanar().empty()}});
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
  std::vector<rhi::Binding> all = m_inputs.bindings;
  all.push_back(rhi::storageAt(STORAGE_TRIANGLE_ORDER, m_noOrder));
  all.insert(all.end(), extra.begin(), extra.end());
  return DrawList(m_context.view, std::move(all), true);
}

std::vector<std::string> CameraPass::warnings() {
  return m_transparency ? m_transparency->warnings() : std::vector<std::string>();
}

void CameraPass::recordOpaque(Frame& frame) {
  const glm::vec3 background = m_context.view.scene().background;
  const rhi::ColorAttachment color{.view = {.texture = m_color},
                                   .clear = {background.r, background.g, background.b, 1}};
  frame.pass({.label = "opaque",
              .colors = std::span(&color, 1),
              .depth = rhi::DepthAttachment{.view = {.texture = m_depth}},
              .reads = m_inputs.reads},
             PassGroup::Scene, [&](rhi::CommandList& commands) {
               for (const Bucket& b : m_buckets)
                 m_drawList.draw(commands, b.pipeline, b.instances);
             });
}

void CameraPass::drawOpaque(rhi::CommandList& commands, DrawList& draws,
                            rhi::PipelineId singleSided, rhi::PipelineId doubleSided) const {
  for (const Bucket& b : m_buckets)
    draws.draw(commands, b.doubleSided ? doubleSided : singleSided, b.instances);
}

void CameraPass::recordTranslucent(Frame& frame) {
  // A step that shows none, though others do.
  if (view().steps() > 1 && translucent().empty()) return;
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
              .depth = rhi::DepthAttachment{.view = {.texture = m_depth},
                                            .load = rhi::LoadOp::Load,
                                            .readOnly = true},
              .reads = m_inputs.reads},
             PassGroup::Scene, body);
}

void CameraPass::surfacePass(Frame& frame, rhi::PassDesc desc,
                             const std::function<void(rhi::CommandList&)>& body) {
  std::vector<rhi::ResourceUse> reads(desc.reads.begin(), desc.reads.end());
  reads.insert(reads.end(), m_inputs.reads.begin(), m_inputs.reads.end());
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
