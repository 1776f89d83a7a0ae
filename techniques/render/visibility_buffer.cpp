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
  rhi::GraphicsPipelineDesc desc = camera.surfacePipeline(
      "visibility",
      context.view.gpu().coplanar().empty() ? "visibility.frag" : "visibility_coplanar.frag", false);
  desc.targets = {{.format = rhi::Format::RGBA32Float}};
  m_doubleSided = context.pipeline(desc);
  desc.raster.cull = rhi::CullMode::Back;
  m_singleSided = context.pipeline(desc);
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

  std::vector<rhi::ResourceUse> reads = m_camera.inputs().reads;
  if (layer > 0) reads.push_back(rhi::use(m_opaqueDepth.id(), rhi::Access::Sampled));
  if (layer > 1) reads.push_back(rhi::use(previous, rhi::Access::Sampled));
  rhi::FrameScope frame(m_context.device);
  rhi::CommandList& commands = frame.commands();
  commands.write(m_pass, 0, std::as_bytes(std::span(ids)));
  recordLayer(commands, layer, draws, reads);
  frame.endAndWait();
  const auto bytes = m_context.device.read(m_target);
  VisibilityImage image(bytes.size() / sizeof(float));
  std::memcpy(image.data(), bytes.data(), bytes.size());
  return image;
}

void VisibilityBuffer::recordLayer(rhi::CommandList& commands, uint32_t layer, DrawList& draws,
                                   std::span<const rhi::ResourceUse> reads) {
  const rhi::TextureId depth = layer == 0 ? m_opaqueDepth.id() : m_layerDepth[layer % 2].id();
  const auto pass = [&](rhi::LoadOp load, const auto& body) {
    const rhi::ColorAttachment color{.view = {.texture = m_target}, .load = load};
    rhi::PassScope scope =
        commands.beginPass({.label = "visibility",
                            .colors = std::span(&color, 1),
                            .depth = rhi::DepthAttachment{.view = {.texture = depth}, .load = load},
                            .reads = reads});
    body();
  };
  const auto translucent = [&](std::span<const uint32_t> instances) {
    pass(rhi::LoadOp::Load, [&] { draws.draw(commands, m_doubleSided, instances); });
  };
  SurfaceDraws surfaces{.opaque = [&] {
    pass(rhi::LoadOp::Clear,
         [&] { m_camera.drawOpaque(commands, draws, m_singleSided, m_doubleSided); });
  }};
  if (layer > 0) {
    surfaces.translucent = [&] { translucent(m_camera.translucent()); };
    surfaces.translucentPart = translucent;
  }
  Frame frame(commands, m_queries, FrameMode::Plain);
  recordInOrder(frame, m_technique, surfaces, Maps::Stand);
}

}  // namespace sb
