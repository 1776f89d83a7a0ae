// Descriptions of device objects, passes and draws: plain structs with defaults, meant for designated
// initialisers. `label` is required wherever it exists: it reaches the debuggers and the reports.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "backends/rhi/handles.h"
#include "backends/rhi/shader.h"
#include "backends/rhi/types.h"

namespace rhi {

// ---- resources ------------------------------------------------------------------------------

struct BufferDesc {
  std::string label;
  uint64_t size = 0;  ///< bytes, > 0
  BufferUse use = BufferUse::None;
};

struct TextureDesc {
  std::string label;
  TextureKind kind = TextureKind::Tex2D;
  Format format = Format::Undefined;
  uint32_t width = 1;
  uint32_t height = 1;
  uint32_t depth = 1;    ///< Tex3D only
  uint32_t layers = 1;   ///< Tex2DArray only
  uint32_t mips = 1;
  uint32_t samples = 1;  ///< 1 or a count in Limits::sampleCounts; 2-D kinds only
  TextureUse use = TextureUse::None;
  bool operator==(const TextureDesc&) const = default;
};

/// A part of a texture. A Tex2DArray stays an array when viewed; mips are relative to level 0.
struct TextureView {
  TextureId texture;
  uint32_t baseMip = 0;
  uint32_t mipCount = kAllRemaining;
  uint32_t baseLayer = 0;
  uint32_t layerCount = kAllRemaining;
  bool operator==(const TextureView&) const = default;
};

/// The texels an upload or a read-back covers: one mip, one layer (or z slice), a rectangle.
struct TextureRegion {
  uint32_t mip = 0;
  uint32_t layer = 0;  ///< array layer, or z of a Tex3D
  uint32_t x = 0;
  uint32_t y = 0;
  uint32_t width = kAllRemaining;
  uint32_t height = kAllRemaining;
};

struct SamplerDesc {
  std::string label;
  Filter filter = Filter::Linear;  ///< minification and magnification alike
  Filter mipFilter = Filter::Nearest;
  AddressMode addressU = AddressMode::Repeat;
  AddressMode addressV = AddressMode::Repeat;
  AddressMode addressW = AddressMode::Repeat;
  BorderColor border = BorderColor::TransparentBlack;
  std::optional<CompareOp> compare;  ///< set: a comparison sampler (sampler2DShadow)
  float maxLod = 0;                  ///< 0: level 0 only
};

struct QueryPoolDesc {
  std::string label;
  QueryKind kind = QueryKind::Timestamp;
  uint32_t count = 0;
};

// ---- pipelines ------------------------------------------------------------------------------

enum class VertexFormat : uint8_t { Float, Float2, Float3, Float4, Uint, Uint2, Uint4, Unorm8x4 };

struct VertexAttribute {
  uint32_t location = 0;
  uint32_t buffer = 0;  ///< index into DrawState::vertexBuffers
  VertexFormat format = VertexFormat::Float3;
  uint32_t offset = 0;  ///< bytes
};
struct VertexBufferLayout {
  uint32_t stride = 0;  ///< bytes
  bool perInstance = false;
};

struct RasterState {
  CullMode cull = CullMode::None;  ///< front faces are counter-clockwise as seen in clip space, y up
  bool depthClamp = false;         ///< keeps what lies before near and beyond far; Feature::DepthClamp
  float depthBiasConstant = 0;     ///< in units of the depth format (not portable, spec 01 P3)
  float depthBiasSlope = 0;
};
struct DepthState {
  bool test = false;
  bool write = false;
  CompareOp compare = CompareOp::Less;
};
struct StencilFace {
  CompareOp compare = CompareOp::Always;
  StencilOp fail = StencilOp::Keep;
  StencilOp depthFail = StencilOp::Keep;
  StencilOp pass = StencilOp::Keep;
};
struct StencilState {
  bool test = false;
  StencilFace front;
  StencilFace back;
  uint8_t readMask = 0xFF;
  uint8_t writeMask = 0xFF;
};
struct BlendState {
  bool enabled = false;
  BlendFactor srcColor = BlendFactor::One;
  BlendFactor dstColor = BlendFactor::Zero;
  BlendOp colorOp = BlendOp::Add;
  BlendFactor srcAlpha = BlendFactor::One;
  BlendFactor dstAlpha = BlendFactor::Zero;
  BlendOp alphaOp = BlendOp::Add;
};
struct ColorTargetState {
  Format format = Format::Undefined;
  BlendState blend;
  uint8_t writeMask = 0xF;  ///< bit 0 red .. bit 3 alpha
};
/// Value of specialization constant `id`, as bits; a constant that no stage declares is an error.
struct SpecConstant {
  uint32_t id = 0;
  uint32_t bits = 0;
};

struct GraphicsPipelineDesc {
  std::string label;
  const ShaderCode* vertex = nullptr;
  const ShaderCode* geometry = nullptr;  ///< optional; Feature::GeometryShader
  const ShaderCode* fragment = nullptr;  ///< optional: depth or stencil only
  std::vector<SpecConstant> constants;   ///< shared by all stages
  std::vector<VertexBufferLayout> vertexBuffers;
  std::vector<VertexAttribute> attributes;
  Topology topology = Topology::TriangleList;
  RasterState raster;
  DepthState depth;
  StencilState stencil;
  std::vector<ColorTargetState> targets;
  std::optional<LogicOp> logicOp;  ///< integer targets, blending off; Feature::LogicOp
  Format depthFormat = Format::Undefined;
  uint32_t samples = 1;
  bool sampleShading = false;  ///< one invocation per sample; Feature::SampleRateShading
};

struct ComputePipelineDesc {
  std::string label;
  const ShaderCode* compute = nullptr;
  std::vector<SpecConstant> constants;
};

// ---- passes ---------------------------------------------------------------------------------

struct ColorAttachment {
  TextureView view;  ///< one mip; layerCount > 1: layered rendering (gl_Layer)
  LoadOp load = LoadOp::Clear;
  StoreOp store = StoreOp::Store;
  std::array<float, 4> clear = {0, 0, 0, 0};  ///< integer formats: converted, saturating
  std::optional<TextureView> resolve;         ///< average of the samples, at the end of the pass
};
struct DepthAttachment {
  TextureView view;
  LoadOp load = LoadOp::Clear;
  StoreOp store = StoreOp::Store;
  float clearDepth = 1;
  bool readOnly = false;  ///< depth is tested but not written: it may also be declared as Sampled
  // Stencil, where the format has one, by itself.
  LoadOp stencilLoad = LoadOp::Clear;
  StoreOp stencilStore = StoreOp::Store;
  uint8_t clearStencil = 0;
  bool stencilReadOnly = false;
};

/// A declared access. Exactly one of `buffer` and `view.texture` is set.
struct ResourceUse {
  BufferId buffer;
  TextureView view;
  Access access = Access::Sampled;
};
inline ResourceUse use(BufferId buffer, Access access) { return {.buffer = buffer, .access = access}; }
inline ResourceUse use(TextureView view, Access access) { return {.view = view, .access = access}; }
inline ResourceUse use(TextureId texture, Access access) {
  return {.view = {.texture = texture}, .access = access};
}

/// A pass: what it draws into and what else it touches. Every resource that an earlier pass wrote
/// must be declared here when this pass touches it, attachments excepted: barriers and layouts
/// follow from this alone. Resources written by uploads (Device::upload, CommandList::write and the
/// copies) are visible to every later pass without a word.
struct PassDesc {
  std::string label;
  bool compute = false;  ///< dispatches only, no attachments
  std::span<const ColorAttachment> colors = {};
  std::optional<DepthAttachment> depth = {};
  std::span<const ResourceUse> reads = {};
  std::span<const ResourceUse> writes = {};
  Extent2D extent = {};  ///< needed without attachments (list builds)
};

/// A clear value for an integer format. It saturates: 0xFFFFFFFF, the end of every list, rounds up to
/// 2^32 as a float.
template <class T>
T integerClear(float value) {
  return T(std::clamp(double(value), double(std::numeric_limits<T>::min()),
                      double(std::numeric_limits<T>::max())));
}

// ---- draws ----------------------------------------------------------------------------------

/// One resource at one slot. Slots that the pipeline does not use are ignored, so that a common set
/// of bindings serves every pass.
struct Binding {
  uint32_t slot = 0;
  BufferId buffer;              ///< uniform and storage slots
  uint64_t offset = 0;          ///< bytes; uniform: a multiple of Limits::uniformAlignment
  uint64_t size = kWholeSize;   ///< bytes
  TextureView view;             ///< texture and image slots
  SamplerId sampler;            ///< texture slots
  bool operator==(const Binding&) const = default;
};
inline Binding uniformAt(uint32_t index, BufferId b, uint64_t offset = 0, uint64_t size = kWholeSize) {
  return {.slot = kUniformSlotBase + index, .buffer = b, .offset = offset, .size = size};
}
inline Binding storageAt(uint32_t index, BufferId b, uint64_t offset = 0, uint64_t size = kWholeSize) {
  return {.slot = kStorageSlotBase + index, .buffer = b, .offset = offset, .size = size};
}
inline Binding textureAt(uint32_t index, TextureView view, SamplerId sampler) {
  return {.slot = kTextureSlotBase + index, .view = view, .sampler = sampler};
}
inline Binding textureAt(uint32_t index, TextureId texture, SamplerId sampler) {
  return textureAt(index, TextureView{.texture = texture}, sampler);
}
inline Binding imageAt(uint32_t index, TextureView view) {
  return {.slot = kImageSlotBase + index, .view = view};
}

struct VertexBufferBinding {
  BufferId buffer;
  uint64_t offset = 0;
};

/// All state of a draw; nothing persists from one draw to the next.
struct DrawState {
  PipelineId pipeline;
  std::span<const Binding> bindings = {};
  std::span<const VertexBufferBinding> vertexBuffers = {};
  BufferId indexBuffer = {};
  uint64_t indexOffset = 0;  ///< bytes
  IndexType indexType = IndexType::Uint32;
  std::optional<Viewport> viewport = {};  ///< default: the whole target, depth 0..1
  std::optional<Rect> scissor = {};       ///< default: the whole target
  uint8_t stencilReference = 0;
  std::array<float, 4> blendConstant = {0, 0, 0, 0};
};

struct DrawArgs {
  uint32_t vertexCount = 0;
  uint32_t instanceCount = 1;
  uint32_t firstVertex = 0;
};
struct DrawIndexedArgs {
  uint32_t indexCount = 0;
  uint32_t instanceCount = 1;
  uint32_t firstIndex = 0;
  int32_t vertexOffset = 0;
  /// Of attributes that advance once an instance. gl_InstanceIndex counts from it in Vulkan alone:
  /// shaders that read it are drawn from 0.
  uint32_t firstInstance = 0;
};
/// Arguments from a buffer, in the layout that Vulkan and OpenGL share (4 or 5 uint32 per draw;
/// dispatch: 3). firstInstance must be 0.
struct IndirectArgs {
  BufferId buffer;
  uint64_t offset = 0;
  uint32_t drawCount = 1;
  uint32_t stride = 0;  ///< 0: tightly packed
};

struct DispatchState {
  PipelineId pipeline;
  std::span<const Binding> bindings = {};
};

}  // namespace rhi
