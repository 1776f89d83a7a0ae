// A pipeline: a program and all fixed state, translated once at creation. State applies it.
#pragma once

#include <array>
#include <vector>

#include "backends/opengl/resources/gl_object.h"
#include "backends/rhi/desc.h"

namespace opengl {

struct BlendTarget {
  bool enabled = false;
  GLenum srcColor = GL_ONE, dstColor = GL_ZERO, colorOp = GL_FUNC_ADD;
  GLenum srcAlpha = GL_ONE, dstAlpha = GL_ZERO, alphaOp = GL_FUNC_ADD;
  bool operator==(const BlendTarget&) const = default;
};

struct StencilOps {
  GLenum fail = GL_KEEP, depthFail = GL_KEEP, pass = GL_KEEP;
  bool operator==(const StencilOps&) const = default;
};

struct FixedState {
  GLenum cullFace = GL_NONE;
  bool depthClamp = false;
  std::array<float, 2> depthBias = {0, 0};  ///< slope, constant
  bool depthTest = false, depthWrite = false;
  GLenum depthCompare = GL_LESS;
  bool stencilTest = false;
  std::array<StencilOps, 2> stencil;  ///< front, back
  std::array<GLenum, 2> stencilCompare = {GL_ALWAYS, GL_ALWAYS};
  uint8_t stencilReadMask = 0xFF, stencilWriteMask = 0xFF;
  std::array<BlendTarget, rhi::kMaxColorAttachments> blend;
  std::array<uint8_t, rhi::kMaxColorAttachments> colorMask;
  GLenum logicOp = GL_NONE;
  bool sampleShading = false;
};

struct VertexInput {
  std::vector<rhi::VertexBufferLayout> buffers;
  std::vector<rhi::VertexAttribute> attributes;
};

class Pipeline {
 public:
  /// Throws rhi::Error with the label and the driver's log.
  Pipeline(const Functions& gl, const rhi::GraphicsPipelineDesc& desc);
  Pipeline(const Functions& gl, const rhi::ComputePipelineDesc& desc);

  GLuint program() const { return m_program.get(); }
  const FixedState& fixed() const { return m_fixed; }
  const VertexInput& vertexInput() const { return m_vertexInput; }
  GLenum topology() const { return m_topology; }
  /// Bit per slot that a shader of this pipeline uses.
  uint64_t slots() const { return m_slots; }

 private:
  UniqueName m_program;
  FixedState m_fixed;
  VertexInput m_vertexInput;
  GLenum m_topology = GL_TRIANGLES;
  uint64_t m_slots = 0;
};

}  // namespace opengl
