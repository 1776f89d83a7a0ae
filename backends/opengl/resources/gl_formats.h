// Translation of the interface's enumerations to OpenGL's: formats, states, vertex formats.
#pragma once

#include "backends/opengl/device/gl_functions.h"
#include "backends/rhi/desc.h"

namespace opengl {

/// How OpenGL stores a format, and how it takes and gives its texels (of `aspect` Color or Depth).
struct FormatTriple {
  GLenum internalFormat = 0;
  GLenum format = 0;
  GLenum type = 0;
};
const FormatTriple& formatTriple(rhi::Format format);

struct VertexFormatInfo {
  GLint components = 0;
  GLenum type = 0;
  bool normalized = false;
  bool integer = false;
};
VertexFormatInfo vertexFormat(rhi::VertexFormat format);

GLenum textureTarget(rhi::TextureKind kind, uint32_t samples);
GLenum compareOp(rhi::CompareOp op);
GLenum stencilOp(rhi::StencilOp op);
GLenum blendOp(rhi::BlendOp op);
GLenum blendFactor(rhi::BlendFactor factor);
GLenum logicOp(rhi::LogicOp op);
GLenum topology(rhi::Topology topology);
GLenum addressMode(rhi::AddressMode mode);
GLenum shaderStage(rhi::ShaderStage stage);

}  // namespace opengl
