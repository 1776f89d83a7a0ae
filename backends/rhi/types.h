// Plain types of the rendering hardware interface: formats, states and small value structs.
// One vocabulary for Vulkan and OpenGL; every name is the field's usual term. No API header is
// included here or anywhere else above the backends.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

namespace rhi {

/// Texel formats. Names give channels, bits and interpretation; `RGB10A2Unorm` is A2B10G10R10.
enum class Format : uint8_t {
  Undefined,
  R8Unorm, RG8Unorm, RGBA8Unorm, RGBA8Srgb,
  RGB10A2Unorm,
  R16Unorm, RG16Unorm, RGBA16Unorm,
  R16Float, RG16Float, RGBA16Float,
  R32Float, RG32Float, RGBA32Float,
  R8Uint, R16Uint, RG16Uint, RGBA16Uint,
  R32Uint, RG32Uint, RGBA32Uint, R32Sint,
  D16Unorm, D24Unorm, D24UnormS8, D32Float, D32FloatS8,
  Count
};

/// What one texel of a format holds.
enum class FormatKind : uint8_t { Unorm, Float, Uint, Sint, Depth };

struct FormatInfo {
  std::string_view name;      ///< stable text, e.g. "RGBA32F", used in records and labels
  uint32_t texelBytes = 0;    ///< bytes of a texel in device memory (D24 and D24S8: 4, D32FS8: 8)
  uint32_t channels = 0;      ///< colour channels; 1 for depth
  FormatKind kind = FormatKind::Unorm;
  bool depth = false;
  bool stencil = false;
};

/// Table lookup; never fails for a value below `Format::Count`.
const FormatInfo& formatInfo(Format format);

/// Which aspect of a texture a read-back returns (colour formats: `Color`).
enum class Aspect : uint8_t { Color, Depth, Stencil };

/// Bytes of one texel in a read-back or an upload of that aspect: colour as in memory; depth D16 as
/// uint16, D24 as uint32 (value in the low 24 bits), D32F as float; stencil as uint8.
uint32_t hostTexelBytes(Format format, Aspect aspect);

enum class CompareOp : uint8_t {
  Never, Less, Equal, LessOrEqual, Greater, NotEqual, GreaterOrEqual, Always
};
enum class StencilOp : uint8_t {
  Keep, Zero, Replace, IncrementClamp, DecrementClamp, Invert, IncrementWrap, DecrementWrap
};
enum class BlendOp : uint8_t { Add, Subtract, ReverseSubtract, Min, Max };
enum class BlendFactor : uint8_t {
  Zero, One,
  SrcColor, OneMinusSrcColor, DstColor, OneMinusDstColor,
  SrcAlpha, OneMinusSrcAlpha, DstAlpha, OneMinusDstAlpha,
  ConstantColor, OneMinusConstantColor,
  Src1Color, OneMinusSrc1Color, Src1Alpha, OneMinusSrc1Alpha
};
enum class LogicOp : uint8_t { Copy, And, Or, Xor, Set, Clear, Invert };
enum class CullMode : uint8_t { None, Front, Back };
enum class Topology : uint8_t { TriangleList, TriangleStrip, LineList, PointList, TrianglesAdjacency };
enum class IndexType : uint8_t { Uint16, Uint32 };
enum class LoadOp : uint8_t { Load, Clear, DontCare };
enum class StoreOp : uint8_t { Store, DontCare };
enum class Filter : uint8_t { Nearest, Linear };
enum class AddressMode : uint8_t { Repeat, MirroredRepeat, ClampToEdge, ClampToBorder };
/// Border of ClampToBorder. White is what a depth comparison needs to read as "lit".
enum class BorderColor : uint8_t { TransparentBlack, OpaqueWhite };
enum class TextureKind : uint8_t { Tex2D, Tex2DArray, Tex3D };
enum class ShaderStage : uint8_t { Vertex, Geometry, Fragment, Compute };
enum class QueryKind : uint8_t { Timestamp, Occlusion, PipelineStatistics };

/// Bit sets of uses. A resource may only be used in ways it was created for.
enum class TextureUse : uint32_t {
  None = 0, Sampled = 1, ColorTarget = 2, DepthTarget = 4, Storage = 8, CopySource = 16, CopyTarget = 32
};
enum class BufferUse : uint32_t {
  None = 0, Vertex = 1, Index = 2, Uniform = 4, Storage = 8, Indirect = 16, CopySource = 32, CopyTarget = 64
};
constexpr TextureUse operator|(TextureUse a, TextureUse b) {
  return TextureUse(uint32_t(a) | uint32_t(b));
}
constexpr BufferUse operator|(BufferUse a, BufferUse b) {
  return BufferUse(uint32_t(a) | uint32_t(b));
}
constexpr bool has(TextureUse set, TextureUse bit) { return (uint32_t(set) & uint32_t(bit)) != 0; }
constexpr bool has(BufferUse set, BufferUse bit) { return (uint32_t(set) & uint32_t(bit)) != 0; }

/// How a pass touches a resource (PassDesc::reads, PassDesc::writes).
enum class Access : uint8_t {
  Uniform, Vertex, Index, Indirect,
  Sampled,       ///< through a sampler, any stage
  StorageRead,   ///< storage buffer or image, read only
  StorageWrite,  ///< storage buffer or image, written or read-modify-written (atomics)
};

struct Extent2D {
  uint32_t width = 0;
  uint32_t height = 0;
  bool operator==(const Extent2D&) const = default;
};
struct Rect {
  int32_t x = 0;
  int32_t y = 0;
  uint32_t width = 0;
  uint32_t height = 0;
};
/// Window transform. Row 0 of the target is y = 0, and clip-space y = -1 maps to `y`: light-space
/// uv = 0.5 + 0.5 * ndc addresses the texel a fragment was written to, on every API.
struct Viewport {
  float x = 0;
  float y = 0;
  float width = 0;
  float height = 0;
  float minDepth = 0;
  float maxDepth = 1;
};

constexpr uint32_t kAllRemaining = std::numeric_limits<uint32_t>::max();
constexpr uint64_t kWholeSize = std::numeric_limits<uint64_t>::max();
constexpr uint32_t kFramesInFlight = 2;
constexpr uint32_t kMaxColorAttachments = 8;

// One flat numbering of binding slots; the slot alone tells the kind of resource, so that the map to
// OpenGL's per-type units is a subtraction (image units must stay below 8, facts.md).
constexpr uint32_t kUniformSlotBase = 0;   // 8 uniform buffers (all with dynamic offsets on Vulkan)
constexpr uint32_t kStorageSlotBase = 8;   // 16 storage buffers
constexpr uint32_t kTextureSlotBase = 24;  // 32 sampled textures
constexpr uint32_t kImageSlotBase = 56;    // 8 storage images
constexpr uint32_t kSlotCount = 64;

}  // namespace rhi
