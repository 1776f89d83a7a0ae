#include "techniques/render/visibility_buffer.h"

#include <cstring>

#include "shaders/common/shared_slots.h"
#include "shaders/common/shared_types.h"
#include "techniques/render/frame_order.h"

namespace sb {
namespace {

bool isEmpty(const VisibilityImage& image) {
  for (size_t i = 3; i < image.size(); i += 4)
    if (image[i] != 0) return false;
  return true;
}

}  // namespace

VisibilityBuffer::VisibilityBuffer(const Context& context, const CameraPass& camera,
                                   ShadowTechnique* technique, FrameQueries& queries)
    : m_context(context), m_camera(camera), m_technique(technique), m_queries(queries) {
  rhi::Device& device = context.device;
  const auto [width, height] = context.view.size();
  using U = rhi::TextureUse;
  auto texture = [&](const char* label, rhi::Format format, U use) {
    return device.createTexture({.label = label,
                                 .format = format,
                                 .width = width,
                                 .height = height,
                                 .use = use | U::Sampled | U::CopySource});
  };
  m_target = texture("visibility target", rhi::Format::RGBA32Float, U::ColorTarget);
  m_opaqueDepth = texture("visibility opaque depth", rhi::Format::D32Float, U::DepthTarget);
  for (auto& depth : m_layerDepth)
    depth = texture("visibility layer depth", rhi::Format::D32Float, U::DepthTarget);
  m_pass = device.createBuffer({.label = "visibility pass",
                                .size = 16,
                                .use = rhi::BufferUse::Uniform | rhi::BufferUse::CopyTarget});
  m_sampler = device.createSampler({.label = "visibility sampler", .filter = rhi::Filter::Nearest});
  const auto answer = [&](CameraPass::Receivers receivers) {
    const char* pass = camera.coplanar() ? "/visibility_coplanar.frag" : "/visibility.frag";
    rhi::GraphicsPipelineDesc desc =
        camera.surfacePipeline("visibility", camera.folder(receivers) + pass, false);
    desc.targets = {{.format = rhi::Format::RGBA32Float}};
    desc.depthFormat = rhi::Format::D32Float;
    return desc;
  };
  m_answer =
      pipelines(answer(CameraPass::Receivers::Opaque), answer(CameraPass::Receivers::Translucent));
  if (!camera.byLayer()) return;
  m_receiverDepth = texture("visibility receivers", camera.depthFormat(), U::DepthTarget);
  rhi::GraphicsPipelineDesc depth = camera.unshadedPipeline(
      camera.coplanar() ? "common/visibility_depth_coplanar.frag" : "common/visibility_depth.frag");
  depth.depth = {.test = true, .write = true, .compare = CameraPass::kNearer};
  depth.depthFormat = camera.depthFormat();
  m_depthOnly = pipelines(depth, depth);
}

VisibilityBuffer::Pipelines VisibilityBuffer::pipelines(
    rhi::GraphicsPipelineDesc opaque, rhi::GraphicsPipelineDesc translucent) const {
  Pipelines made;
  made.doubleSided = m_context.pipeline(opaque);
  opaque.raster.cull = rhi::CullMode::Back;
  made.singleSided = m_context.pipeline(opaque);
  made.translucent = m_context.pipeline(translucent);
  return made;
}

std::vector<VisibilityImage> VisibilityBuffer::render(ViewLight light) {
  std::vector<VisibilityImage> images;
  const bool translucent = !m_context.view.effects().visibleTranslucent.empty();
  for (uint32_t layer = 0; layer <= kLayers; ++layer) {
    if (layer == 1 && !translucent)
      images.push_back(images[0]);  // the first surface is the first opaque one
    else if (layer > 1 && (!translucent || isEmpty(images.back())))
      images.emplace_back(images[0].size(), 0.0f);
    else
      images.push_back(renderLayer(light, layer));
  }
  return images;
}

VisibilityImage VisibilityBuffer::renderLayer(ViewLight light, uint32_t layer) {
  const SceneView& view = m_context.view;
  const rhi::TextureId previous = m_layerDepth[(layer + 1) % 2];
  const uint32_t ids[4] = {uint32_t(light), layer, 0, 0};

  std::vector<rhi::Binding> extra = {rhi::uniformAt(UNIFORM_PASS, m_pass)};
  // The first passes have no earlier depth; whatever is bound there, they do not read it.
  const rhi::TextureId unread = view.gpu().textures(0).front().view.texture;
  extra.push_back(rhi::textureAt(TEXTURE_PREVIOUS_LAYER, layer > 1 ? previous : unread, m_sampler));
  extra.push_back(
      rhi::textureAt(TEXTURE_TRANSPARENCY, layer > 0 ? m_opaqueDepth.id() : unread, m_sampler));
  DrawList draws = m_camera.drawListWith(extra);

  rhi::FrameScope scope(m_context.device);
  scope.commands().write(m_pass, 0, std::as_bytes(std::span(ids)));
  Frame frame(scope.commands(), m_queries, FrameMode::Plain);
  recordLayer(frame, layer, draws);
  scope.endAndWait();
  const auto bytes = m_context.device.read(m_target);
  VisibilityImage image(bytes.size() / sizeof(float));
  std::memcpy(image.data(), bytes.data(), bytes.size());
  return image;
}

std::vector<rhi::ResourceUse> VisibilityBuffer::depthReads(uint32_t layer) const {
  std::vector<rhi::ResourceUse> reads;
  if (layer > 0) reads.push_back(rhi::use(m_opaqueDepth.id(), rhi::Access::Sampled));
  if (layer > 1)
    reads.push_back(rhi::use(m_layerDepth[(layer + 1) % 2].id(), rhi::Access::Sampled));
  return reads;
}

void VisibilityBuffer::recordLayer(Frame& frame, uint32_t layer, DrawList& draws) {
  m_camera.recordLayer(
      frame, {.depth = m_receiverDepth, .index = layer}, [&] { recordDepth(frame, layer, draws); },
      [&] { recordAnswer(frame, layer, draws); });
}

void VisibilityBuffer::recordDepth(Frame& frame, uint32_t layer, DrawList& draws) {
  const auto reads = depthReads(layer);
  frame.pass({.label = "receivers",
              .depth = rhi::DepthAttachment{.view = {.texture = m_receiverDepth},
                                            .clearDepth = CameraPass::kFarDepth},
              .reads = reads},
             PassGroup::Shadow, [&](rhi::CommandList& commands) {
               m_camera.opaque().drawWith(commands, draws, m_depthOnly.singleSided,
                                          m_depthOnly.doubleSided);
               if (layer > 0) draws.draw(commands, m_depthOnly.translucent, m_camera.translucent());
             });
}

void VisibilityBuffer::recordAnswer(Frame& frame, uint32_t layer, DrawList& draws) {
  const rhi::TextureId depth = layer == 0 ? m_opaqueDepth.id() : m_layerDepth[layer % 2].id();
  std::vector<rhi::ResourceUse> reads = m_camera.inputs().reads;
  for (const rhi::ResourceUse& use : depthReads(layer)) reads.push_back(use);
  const auto pass = [&](rhi::LoadOp load, const std::function<void(rhi::CommandList&)>& body) {
    const rhi::ColorAttachment color{.view = {.texture = m_target}, .load = load};
    frame.pass({.label = "visibility",
                .colors = std::span(&color, 1),
                .depth = rhi::DepthAttachment{.view = {.texture = depth},
                                              .load = load,
                                              .clearDepth = CameraPass::kFarDepth},
                .reads = reads},
               PassGroup::Scene, body);
  };
  const auto translucent = [&](std::span<const uint32_t> instances) {
    pass(rhi::LoadOp::Load, [&](rhi::CommandList& commands) {
      draws.draw(commands, m_answer.translucent, instances);
    });
  };
  SurfaceDraws surfaces{.opaque = [&] {
    pass(rhi::LoadOp::Clear, [&](rhi::CommandList& commands) {
      m_camera.opaque().drawWith(commands, draws, m_answer.singleSided, m_answer.doubleSided);
    });
  }};
  if (layer > 0) {
    surfaces.translucent = [&] { translucent(m_camera.translucent()); };
    surfaces.translucentPart = translucent;
  }
  recordInOrder(frame, m_technique, surfaces, Maps::Stand);
}

}  // namespace sb
