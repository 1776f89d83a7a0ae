// The context's state as last set. Every draw names all of its state; only what differs from the
// last draw reaches OpenGL. Objects are compared by id, whose generation tells a new object from a
// destroyed one with the same GL name.
#pragma once

#include <array>
#include <optional>

#include "backends/opengl/resources/gl_objects.h"
#include "backends/rhi/device_info.h"

namespace opengl {

class State {
 public:
  State(const Functions& gl, Objects& objects, const rhi::Limits& limits);

  /// After objects were deleted, perhaps within a pass: the driver has reset bindings behind our
  /// back. The framebuffer stays bound unless it is the one that went.
  void forgetBindings();
  void forgetFramebuffer(GLuint framebuffer);

  /// Binds and notes what the pass allows.
  void beginPass(GLuint framebuffer, rhi::Extent2D extent,
                 const std::optional<rhi::DepthAttachment>& depth);
  /// Clears, blits and invalidations heed masks and the scissor; the interface's do not.
  void openMasks();

  void applyDraw(const rhi::DrawState& draw, bool indexed);
  void applyDispatch(const rhi::DispatchState& dispatch);
  void bindIndirect(GLenum target, rhi::BufferId buffer);

 private:
  struct StencilTest {
    GLenum compare = GL_ALWAYS;
    GLint reference = 0;
    GLuint mask = 0xFF;
    bool operator==(const StencilTest&) const = default;
  };
  struct ViewportBox {
    rhi::Viewport v;
    bool operator==(const ViewportBox& o) const {
      return v.x == o.v.x && v.y == o.v.y && v.width == o.v.width && v.height == o.v.height &&
             v.minDepth == o.v.minDepth && v.maxDepth == o.v.maxDepth;
    }
  };
  struct VertexSource {
    rhi::BufferId buffer;
    uint64_t offset = 0;
    bool operator==(const VertexSource&) const = default;
  };

  void setOnce();
  void enable(GLenum capability, bool on, bool& current);
  void useProgram(const Pipeline& pipeline);
  void applyRaster(const FixedState& s);
  void applyDepthStencil(const FixedState& s, uint8_t reference);
  void applyBlend(const FixedState& s);
  void setBlendTarget(GLuint index, const BlendTarget& target);
  void setColorMask(GLuint index, uint8_t mask);
  void applyViewport(const rhi::DrawState& draw);
  void applyVertexInput(const Pipeline& pipeline, const rhi::DrawState& draw, bool indexed);
  void setVertexFormats(const VertexInput& input);
  void applyBindings(std::span<const rhi::Binding> bindings, uint64_t slots);
  void bind(const rhi::Binding& binding);

  const Functions& m_gl;
  Objects& m_objects;
  const rhi::Limits m_limits;
  UniqueName m_vertexArray;

  rhi::Extent2D m_extent;
  bool m_depthReadOnly = false, m_stencilReadOnly = false;

  // Mirrors of the context; the initial values are OpenGL's own.
  GLuint m_framebuffer = 0;
  GLuint m_program = 0;
  rhi::PipelineId
      m_pipeline;  ///< whose fixed state is applied; none after anything else touched it
  bool m_cull = false, m_clamp = false, m_bias = false, m_sampleShading = false;
  GLenum m_cullFace = GL_BACK;
  std::array<float, 2> m_depthBias = {0, 0};
  bool m_depthTest = false, m_depthWrite = true;
  GLenum m_depthCompare = GL_LESS;
  bool m_stencilTest = false;
  std::array<StencilTest, 2> m_stencil;
  std::array<StencilOps, 2> m_stencilOps;
  uint8_t m_stencilWriteMask = 0xFF;
  std::array<BlendTarget, rhi::kMaxColorAttachments> m_blend;
  std::array<uint8_t, rhi::kMaxColorAttachments> m_colorMask;
  bool m_logic = false;
  GLenum m_logicOp = GL_COPY;
  std::array<float, 4> m_blendConstant = {0, 0, 0, 0};
  std::optional<ViewportBox> m_viewport;
  bool m_scissor = false;
  std::optional<rhi::Rect> m_scissorRect;

  std::array<rhi::Binding, rhi::kSlotCount> m_bound;
  rhi::PipelineId m_inputPipeline;  ///< whose vertex formats the vertex array has
  std::array<VertexSource, 16> m_vertexBuffers;
  std::array<bool, 16> m_attributeOn{};
  rhi::BufferId m_indexBuffer;
  std::array<rhi::BufferId, 2> m_indirect;  ///< draw, dispatch
};

}  // namespace opengl
