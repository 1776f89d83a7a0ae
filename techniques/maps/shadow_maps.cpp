#include "techniques/maps/shadow_maps.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "shaders/common/shared_slots.h"

namespace sb {

std::vector<KnobInfo> shadowMapKnobs(const std::string& defaultKernel) {
  return {
      {.name = "size",
       .unit = "texels",
       .help = "width and height of a shadow map",
       .fallback = "1024",
       .min = 4,
       .max = 16384,
       .sweep = {"256", "512", "1024", "2048", "4096"}},
      {.name = "kernel",
       .unit = "texels",
       .help = "width of the percentage-closer filter",
       .fallback = defaultKernel,
       .min = 1,
       .max = 63,
       .odd = true,
       .sweep = {"1", "3", "5", "9", "15"}},
      {.name = "shape",
       .help = "weights of the filter",
       .fallback = "box",
       .choices = {"box", "tent"}},
      {.name = "bias",
       .help = "what keeps a lit surface from shadowing itself",
       .fallback = "plane",
       .choices = {"plane", "slope", "normal", "constant"}},
      {.name = "fit",
       .help = "light frustum: tight around what is seen, or of constant extent",
       .fallback = "tight",
       .choices = {"tight", "stable"}},
      {.name = "depth",
       .help = "format of the depth map",
       .fallback = "d32f",
       .choices = {"d16", "d24", "d32f"},
       .sweep = {"d16", "d24", "d32f"}},
  };
}

float depthStep(rhi::Format format) {
  switch (format) {
    case rhi::Format::RGB10A2Unorm:
      return 0x1p-10f;
    case rhi::Format::D16Unorm:
    case rhi::Format::RGBA16Unorm:
      return 0x1p-16f;
    case rhi::Format::D24Unorm:
    case rhi::Format::D24UnormS8:
      return 0x1p-24f;
    default:
      return 0;  // floats keep the depth that was computed
  }
}

KnobInfo mapSamplesKnob() {
  return {.name = "msaa",
          .unit = "samples",
          .help = "of a texel, each an experiment of its own, compared one by one",
          .fallback = "1",
          .choices = {"1", "4"},
          .sweep = {"1", "4"}};
}

namespace {

/// From a receiver to the farthest texel (or sample of one) of its filter, along an axis: half the
/// kernel from the receiver's texel's centre to a centre, half a texel more to the four of a
/// hardware tap and to samples. 0: no caster rises before itself, or another bias is asked for.
float recedingReach(const Context& context, uint32_t kernel, uint32_t samples) {
  if (!context.knobs.is("bias", "plane")) return 0;
  const auto rises = [&](uint32_t i) { return context.view.gpu().everRises(i); };
  if (std::ranges::none_of(context.view.lightViews(), [&](const LightView& v) {
        return std::ranges::any_of(v.opaque, rises) || std::ranges::any_of(v.perforated, rises) ||
               std::ranges::any_of(v.translucent, rises);
      }))
    return 0;
  const auto compare = context.knobs.all().find("compare");
  const bool wide =
      samples > 1 || (compare != context.knobs.all().end() && compare->second == "hardware");
  return 0.5f * float(wide ? kernel + 1 : kernel);
}

/// "common/masked.frag" to "common/masked_receding.frag".
std::string recedingName(const rhi::ShaderCode* fragment) {
  if (!fragment) return "common/receding.frag";
  std::string name = fragment->name;
  return name.insert(name.rfind('.'), "_receding");
}

}  // namespace

ShadowMaps::ShadowMaps(const Context& context, float step, DepthShape shape)
    : m_view(context.view), m_shape(shape) {
  const Knobs& knobs = context.knobs;
  m_size = knobs.integer("size");
  m_kernel = knobs.integer("kernel");
  m_depthFormat = knobs.is("depth", "d16")   ? rhi::Format::D16Unorm
                  : knobs.is("depth", "d24") ? rhi::Format::D24Unorm
                                             : rhi::Format::D32Float;
  if (m_depthFormat == rhi::Format::D24Unorm &&
      !context.device.formatCaps(m_depthFormat).depthTarget)
    m_depthFormat = rhi::Format::D24UnormS8;
  context.view.fitLightViews(context.device,
                             {.mapSize = m_size,
                              .guardTexels = std::min(knobs.integer("kernel") / 2 + 2, m_size / 4),
                              .fit = knobs.is("fit", "stable") ? LightFit::Stable : LightFit::Tight,
                              .depthStep = std::max(step, depthStep(m_depthFormat)),
                              .depthClamp = context.device.supports(rhi::Feature::DepthClamp),
                              .reachTranslucent = shape.reachTranslucent});
  m_recedes = recedingReach(context, m_kernel, shape.samples);
  m_layers = uint32_t(std::ranges::count_if(views(), [](auto& v) { return v.layer >= 0; }));

  if (std::ranges::count(context.device.formatCaps(m_depthFormat).sampleCounts, shape.samples) == 0)
    throw rhi::Error("shadow map depth", "",
                     "the device has no " + std::string(rhi::formatInfo(m_depthFormat).name) +
                         " targets of " + std::to_string(shape.samples) + " samples");
  m_depth =
      context.device.createTexture({.label = "shadow map depth",
                                    .kind = rhi::TextureKind::Tex2DArray,
                                    .format = m_depthFormat,
                                    .width = m_size,
                                    .height = m_size,
                                    .layers = std::max(1u, m_layers) * shape.layersPerView,
                                    .samples = shape.samples,
                                    .use = rhi::TextureUse::DepthTarget | rhi::TextureUse::Sampled |
                                           rhi::TextureUse::CopySource});
  m_pointSampler = context.device.createSampler({.label = "shadow map points",
                                                 .filter = rhi::Filter::Nearest,
                                                 .addressU = rhi::AddressMode::ClampToEdge,
                                                 .addressV = rhi::AddressMode::ClampToEdge});
  m_passStride = std::max<uint64_t>(16, context.device.info().limits.uniformAlignment);
  std::vector<std::byte> blocks(std::max<size_t>(1, views().size()) * m_passStride);
  for (uint32_t i = 0; i < views().size(); ++i) {
    const uint32_t ids[4] = {i, 0, 0, 0};
    std::memcpy(blocks.data() + i * m_passStride, ids, sizeof ids);
  }
  m_passBlocks =
      context.device.createBuffer({.label = "shadow map passes",
                                   .size = blocks.size(),
                                   .use = rhi::BufferUse::Uniform | rhi::BufferUse::CopyTarget});
  context.device.upload(m_passBlocks, 0, blocks);
  for (size_t i = 0; i < views().size(); ++i) {
    m_plain.emplace_back(m_view, std::vector{passBlock(i)}, false);
    m_surfaces.emplace_back(m_view, std::vector{passBlock(i)}, true);
  }
}

rhi::Texture ShadowMaps::createLike(const Context& context, const std::string& label,
                                    rhi::Format format, uint32_t layers) const {
  const bool depth = rhi::formatInfo(format).depth;
  const rhi::FormatCaps caps = context.device.formatCaps(format);
  if (depth ? !caps.depthTarget : !caps.colorTarget || !caps.blend)
    throw rhi::Error(label, "",
                     "the device cannot " + std::string(depth ? "render to " : "blend into ") +
                         std::string(rhi::formatInfo(format).name));
  using U = rhi::TextureUse;
  return context.device.createTexture({.label = label,
                                       .kind = rhi::TextureKind::Tex2DArray,
                                       .format = format,
                                       .width = m_size,
                                       .height = m_size,
                                       .layers = layers > 0 ? layers : std::max(1u, m_layers),
                                       .use = (depth ? U::DepthTarget : U::ColorTarget) |
                                              U::Sampled | U::CopySource | U::CopyTarget});
}

void ShadowMaps::clear(const Context& context, const rhi::Texture& map) {
  const rhi::TextureDesc& desc = context.device.textureDesc(map);
  const bool depth = rhi::formatInfo(desc.format).depth;
  rhi::FrameScope frame(context.device);
  rhi::CommandList& commands = frame.commands();
  for (uint32_t layer = 0; layer < desc.layers; ++layer) {
    const rhi::TextureView view{
        .texture = map, .baseMip = 0, .mipCount = 1, .baseLayer = layer, .layerCount = 1};
    const rhi::ColorAttachment color{.view = view, .clear = {1, 1, 1, 1}};
    rhi::PassDesc pass{.label = "clear", .colors = std::span(&color, depth ? 0 : 1)};
    if (depth) pass.depth = rhi::DepthAttachment{.view = view, .clearDepth = 0};
    const rhi::PassScope scope = commands.beginPass(pass);
  }
  frame.endAndWait();
}

rhi::Binding ShadowMaps::passBlock(size_t view) const {
  return rhi::uniformAt(UNIFORM_PASS, m_passBlocks, view * m_passStride, 16);
}

rhi::DepthAttachment ShadowMaps::depthAttachment(const LightView& view) const {
  return {.view = {.texture = m_depth.id(),
                   .baseMip = 0,
                   .mipCount = 1,
                   .baseLayer = uint32_t(view.layer) * m_shape.layersPerView,
                   .layerCount = m_shape.layersPerView},
          .clearDepth = 0};
}

LookupReach ShadowMaps::reach(uint32_t sceneLight) const {
  LookupReach reach;
  for (const LightView& view : views()) {
    if (view.light != sceneLight || view.layer < 0) continue;
    // A texel's width anywhere, or at distance 1 under a local light: of the face with the widest.
    const double half = 0.5 * double(m_kernel + 1) * double(view.texelWidth);
    double& most = view.perspective ? reach.perDistance : reach.constant;
    most = std::max(most, half);
  }
  return reach;
}

std::vector<rhi::SpecConstant> ShadowMaps::constants(const Knobs& knobs) const {
  static const std::vector<std::string> kBiases = {"plane", "slope", "normal", "constant"};
  return {{16, uint32_t(std::ranges::find(kBiases, knobs.text("bias")) - kBiases.begin())},
          {17, knobs.integer("kernel")},
          {18, knobs.is("shape", "tent")},
          {23, recedes()}};
}

rhi::GraphicsPipelineDesc ShadowMaps::casterPipeline(const Context& context,
                                                     const std::string& label,
                                                     const std::string& fragment,
                                                     bool masked) const {
  const bool surface = !fragment.empty();
  rhi::GraphicsPipelineDesc desc{
      .label = label,
      .vertex = &context.shaders.get(surface ? "common/light_surface.vert" : "common/light.vert"),
      .fragment = surface ? &context.shaders.get(fragment) : nullptr,
      .vertexBuffers = GpuScene::vertexLayout(surface),
      .attributes = GpuScene::vertexAttributes(surface),
      // Casters between the light and the near plane still cast ("pancaking", spec 01).
      .raster = {.depthClamp = context.device.supports(rhi::Feature::DepthClamp)},
      .depth = {.test = true, .write = true, .compare = rhi::CompareOp::Greater},
      .depthFormat = m_depthFormat};
  desc.constants = declaredConstants({desc.vertex, desc.fragment},
                                     {{0, context.view.gpu().textured()}, {2, masked}});
  return desc;
}

CasterPipelines ShadowMaps::pipelines(const Context& context,
                                      const rhi::GraphicsPipelineDesc& desc) const {
  CasterPipelines pair{.exact = context.pipeline(desc), .receding = {}};
  if (!recedes()) return pair;
  rhi::GraphicsPipelineDesc receding = desc;
  if (const rhi::ShaderCode* own = context.shaders.find(recedingName(desc.fragment)))
    receding.fragment = own;
  receding.constants.push_back({15, std::bit_cast<uint32_t>(m_recedes)});
  pair.receding = context.pipeline(receding);
  return pair;
}

}  // namespace sb
