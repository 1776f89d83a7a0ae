#include "backends/opengl/resources/gl_formats.h"

#include <iterator>

namespace opengl {

const FormatTriple& formatTriple(rhi::Format format) {
  static constexpr FormatTriple kTable[] = {
      {0, 0, 0},
      {GL_R8, GL_RED, GL_UNSIGNED_BYTE},
      {GL_RG8, GL_RG, GL_UNSIGNED_BYTE},
      {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
      {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE},
      {GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV},
      {GL_R16, GL_RED, GL_UNSIGNED_SHORT},
      {GL_RG16, GL_RG, GL_UNSIGNED_SHORT},
      {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT},
      {GL_R16F, GL_RED, GL_HALF_FLOAT},
      {GL_RG16F, GL_RG, GL_HALF_FLOAT},
      {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT},
      {GL_R32F, GL_RED, GL_FLOAT},
      {GL_RG32F, GL_RG, GL_FLOAT},
      {GL_RGBA32F, GL_RGBA, GL_FLOAT},
      {GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE},
      {GL_R16UI, GL_RED_INTEGER, GL_UNSIGNED_SHORT},
      {GL_RG16UI, GL_RG_INTEGER, GL_UNSIGNED_SHORT},
      {GL_RGBA16UI, GL_RGBA_INTEGER, GL_UNSIGNED_SHORT},
      {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT},
      {GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT},
      {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT},
      {GL_R32I, GL_RED_INTEGER, GL_INT},
      {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT},
      {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT},
      {GL_DEPTH24_STENCIL8, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT},
      {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT},
      {GL_DEPTH32F_STENCIL8, GL_DEPTH_COMPONENT, GL_FLOAT},
  };
  static_assert(std::size(kTable) == size_t(rhi::Format::Count));
  return kTable[size_t(format)];
}

VertexFormatInfo vertexFormat(rhi::VertexFormat format) {
  switch (format) {
    case rhi::VertexFormat::Float:
      return {1, GL_FLOAT};
    case rhi::VertexFormat::Float2:
      return {2, GL_FLOAT};
    case rhi::VertexFormat::Float3:
      return {3, GL_FLOAT};
    case rhi::VertexFormat::Float4:
      return {4, GL_FLOAT};
    case rhi::VertexFormat::Uint:
      return {1, GL_UNSIGNED_INT, false, true};
    case rhi::VertexFormat::Uint2:
      return {2, GL_UNSIGNED_INT, false, true};
    case rhi::VertexFormat::Uint4:
      return {4, GL_UNSIGNED_INT, false, true};
    case rhi::VertexFormat::Unorm8x4:
      return {4, GL_UNSIGNED_BYTE, true};
  }
  return {};
}

GLenum textureTarget(rhi::TextureKind kind, uint32_t samples) {
  switch (kind) {
    case rhi::TextureKind::Tex2D:
      return samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    case rhi::TextureKind::Tex2DArray:
      return samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE_ARRAY : GL_TEXTURE_2D_ARRAY;
    case rhi::TextureKind::Tex3D:
      return GL_TEXTURE_3D;
  }
  return GL_TEXTURE_2D;
}

GLenum compareOp(rhi::CompareOp op) {
  static constexpr GLenum kTable[] = {GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                                      GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
  return kTable[size_t(op)];
}

GLenum stencilOp(rhi::StencilOp op) {
  static constexpr GLenum kTable[] = {GL_KEEP, GL_ZERO,   GL_REPLACE,   GL_INCR,
                                      GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP};
  return kTable[size_t(op)];
}

GLenum blendOp(rhi::BlendOp op) {
  static constexpr GLenum kTable[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT,
                                      GL_MIN, GL_MAX};
  return kTable[size_t(op)];
}

GLenum blendFactor(rhi::BlendFactor factor) {
  static constexpr GLenum kTable[] = {GL_ZERO,           GL_ONE,
                                      GL_SRC_COLOR,      GL_ONE_MINUS_SRC_COLOR,
                                      GL_DST_COLOR,      GL_ONE_MINUS_DST_COLOR,
                                      GL_SRC_ALPHA,      GL_ONE_MINUS_SRC_ALPHA,
                                      GL_DST_ALPHA,      GL_ONE_MINUS_DST_ALPHA,
                                      GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_COLOR,
                                      GL_SRC1_COLOR,     GL_ONE_MINUS_SRC1_COLOR,
                                      GL_SRC1_ALPHA,     GL_ONE_MINUS_SRC1_ALPHA};
  return kTable[size_t(factor)];
}

GLenum logicOp(rhi::LogicOp op) {
  static constexpr GLenum kTable[] = {GL_COPY, GL_AND, GL_OR, GL_XOR, GL_SET, GL_CLEAR, GL_INVERT};
  return kTable[size_t(op)];
}

GLenum topology(rhi::Topology topology) {
  static constexpr GLenum kTable[] = {GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_LINES, GL_POINTS,
                                      GL_TRIANGLES_ADJACENCY};
  return kTable[size_t(topology)];
}

GLenum addressMode(rhi::AddressMode mode) {
  static constexpr GLenum kTable[] = {GL_REPEAT, GL_MIRRORED_REPEAT, GL_CLAMP_TO_EDGE,
                                      GL_CLAMP_TO_BORDER};
  return kTable[size_t(mode)];
}

GLenum shaderStage(rhi::ShaderStage stage) {
  static constexpr GLenum kTable[] = {GL_VERTEX_SHADER, GL_GEOMETRY_SHADER, GL_FRAGMENT_SHADER,
                                      GL_COMPUTE_SHADER};
  return kTable[size_t(stage)];
}

}  // namespace opengl
