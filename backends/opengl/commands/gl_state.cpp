#include "backends/opengl/commands/gl_state.h"

#include <cassert>

namespace opengl {

State::State(const Functions& gl, Objects& objects, const rhi::Limits& limits)
    : m_gl(gl), m_objects(objects), m_limits(limits) {
  m_colorMask.fill(0xF);
  GLuint name = 0;
  gl.CreateVertexArrays(1, &name);
  m_vertexArray =
      UniqueName(gl, name, [](const Functions& f, GLuint n) { f.DeleteVertexArrays(1, &n); });
  setOnce();
}

void State::setOnce() {
  m_gl.BindVertexArray(m_vertexArray.get());
  // Vulkan's clip space and memory layout: z in 0..1, and row 0 of a texture is clip-space y = -1.
  // With LOWER_LEFT nothing is mirrored, so counter-clockwise in clip space stays so.
  m_gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  m_gl.FrontFace(GL_CCW);
  m_gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
  // gl_PointCoord.y grows with the row, as in Vulkan.
  m_gl.PointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT);
  m_gl.Enable(GL_PROGRAM_POINT_SIZE);
  m_gl.Enable(GL_FRAMEBUFFER_SRGB);
  m_gl.Disable(GL_DITHER);  // on by default, and unknown to Vulkan
  m_gl.MinSampleShading(1);
  m_gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  m_gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

void State::forgetBindings() {
  m_bound.fill({});
  m_vertexBuffers.fill({});
  m_indexBuffer = {};
  m_indirect.fill({});
  m_pipeline = m_inputPipeline = {};
  // Drivers may reuse names, so equality with a mirrored name proves nothing any more.
  m_gl.UseProgram(0);
  m_program = 0;
}

void State::forgetFramebuffer(GLuint framebuffer) {
  if (m_framebuffer == framebuffer) m_framebuffer = 0;
}

void State::enable(GLenum capability, bool on, bool& current) {
  if (on == current) return;
  (on ? m_gl.Enable : m_gl.Disable)(capability);
  current = on;
}

void State::beginPass(GLuint framebuffer, rhi::Extent2D extent,
                      const std::optional<rhi::DepthAttachment>& depth) {
  if (framebuffer != m_framebuffer) m_gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  m_framebuffer = framebuffer;
  m_extent = extent;
  const bool depthReadOnly = depth && depth->readOnly;
  const bool stencilReadOnly = depth && depth->stencilReadOnly;
  if (depthReadOnly != m_depthReadOnly || stencilReadOnly != m_stencilReadOnly) m_pipeline = {};
  m_depthReadOnly = depthReadOnly;
  m_stencilReadOnly = stencilReadOnly;
}

void State::openMasks() {
  m_pipeline = {};
  enable(GL_SCISSOR_TEST, false, m_scissor);
  if (!m_depthWrite) m_gl.DepthMask(GL_TRUE);
  m_depthWrite = true;
  if (m_stencilWriteMask != 0xFF) m_gl.StencilMask(0xFF);
  m_stencilWriteMask = 0xFF;
  for (GLuint i = 0; i < rhi::kMaxColorAttachments; ++i) setColorMask(i, 0xF);
}

void State::useProgram(const Pipeline& pipeline) {
  if (pipeline.program() == m_program) return;
  m_gl.UseProgram(pipeline.program());
  m_program = pipeline.program();
}

void State::applyDraw(const rhi::DrawState& draw, bool indexed) {
  const Pipeline& pipeline = m_objects.pipelines.get(draw.pipeline);
  useProgram(pipeline);
  if (draw.pipeline != m_pipeline) {
    applyRaster(pipeline.fixed());
    applyBlend(pipeline.fixed());
    m_pipeline = draw.pipeline;
    applyDepthStencil(pipeline.fixed(), draw.stencilReference);
  } else if (m_stencil[0].reference != draw.stencilReference) {
    applyDepthStencil(pipeline.fixed(), draw.stencilReference);
  }
  if (draw.blendConstant != m_blendConstant) {
    const auto& c = m_blendConstant = draw.blendConstant;
    m_gl.BlendColor(c[0], c[1], c[2], c[3]);
  }
  applyViewport(draw);
  applyVertexInput(pipeline, draw, indexed);
  applyBindings(draw.bindings, pipeline.slots());
}

void State::applyDispatch(const rhi::DispatchState& dispatch) {
  const Pipeline& pipeline = m_objects.pipelines.get(dispatch.pipeline);
  useProgram(pipeline);
  applyBindings(dispatch.bindings, pipeline.slots());
}

void State::bindIndirect(GLenum target, rhi::BufferId buffer) {
  rhi::BufferId& current = m_indirect[target == GL_DRAW_INDIRECT_BUFFER ? 0 : 1];
  if (current == buffer) return;
  m_gl.BindBuffer(target, m_objects.buffers.get(buffer).name());
  current = buffer;
}

void State::applyRaster(const FixedState& s) {
  enable(GL_CULL_FACE, s.cullFace != GL_NONE, m_cull);
  if (s.cullFace != GL_NONE && s.cullFace != m_cullFace) m_gl.CullFace(m_cullFace = s.cullFace);
  enable(GL_DEPTH_CLAMP, s.depthClamp, m_clamp);
  const bool biased = s.depthBias[0] != 0 || s.depthBias[1] != 0;
  enable(GL_POLYGON_OFFSET_FILL, biased, m_bias);
  if (biased && s.depthBias != m_depthBias) {
    m_depthBias = s.depthBias;
    m_gl.PolygonOffset(m_depthBias[0], m_depthBias[1]);
  }
  enable(GL_SAMPLE_SHADING, s.sampleShading, m_sampleShading);
}

void State::applyDepthStencil(const FixedState& s, uint8_t reference) {
  enable(GL_DEPTH_TEST, s.depthTest, m_depthTest);
  const bool write = s.depthWrite && !m_depthReadOnly;
  if (write != m_depthWrite) m_gl.DepthMask(GLboolean(m_depthWrite = write));
  if (s.depthCompare != m_depthCompare) m_gl.DepthFunc(m_depthCompare = s.depthCompare);
  enable(GL_STENCIL_TEST, s.stencilTest, m_stencilTest);
  const uint8_t mask = m_stencilReadOnly ? 0 : s.stencilWriteMask;
  if (mask != m_stencilWriteMask) m_gl.StencilMask(m_stencilWriteMask = mask);
  for (size_t i = 0; i < 2; ++i) {
    const GLenum face = i == 0 ? GL_FRONT : GL_BACK;
    const StencilTest test{s.stencilCompare[i], reference, s.stencilReadMask};
    if (test != m_stencil[i]) {
      m_gl.StencilFuncSeparate(face, test.compare, test.reference, test.mask);
      m_stencil[i] = test;
    }
    if (const StencilOps& ops = s.stencil[i]; ops != m_stencilOps[i]) {
      m_gl.StencilOpSeparate(face, ops.fail, ops.depthFail, ops.pass);
      m_stencilOps[i] = ops;
    }
  }
}

void State::applyBlend(const FixedState& s) {
  for (GLuint i = 0; i < rhi::kMaxColorAttachments; ++i) {
    if (s.blend[i] != m_blend[i]) setBlendTarget(i, s.blend[i]);
    setColorMask(i, s.colorMask[i]);
  }
  enable(GL_COLOR_LOGIC_OP, s.logicOp != GL_NONE, m_logic);
  if (s.logicOp != GL_NONE && s.logicOp != m_logicOp) m_gl.LogicOp(m_logicOp = s.logicOp);
}

void State::setBlendTarget(GLuint i, const BlendTarget& b) {
  if (b.enabled != m_blend[i].enabled) (b.enabled ? m_gl.Enablei : m_gl.Disablei)(GL_BLEND, i);
  if (b.enabled) {
    m_gl.BlendFuncSeparatei(i, b.srcColor, b.dstColor, b.srcAlpha, b.dstAlpha);
    m_gl.BlendEquationSeparatei(i, b.colorOp, b.alphaOp);
    m_blend[i] = b;
  } else {
    m_blend[i].enabled = false;  // the factors of the context stay as they were
  }
}

void State::setColorMask(GLuint i, uint8_t mask) {
  if (mask == m_colorMask[i]) return;
  auto bit = [&](int n) { return GLboolean((mask >> n) & 1); };
  m_gl.ColorMaski(i, bit(0), bit(1), bit(2), bit(3));
  m_colorMask[i] = mask;
}

void State::applyViewport(const rhi::DrawState& draw) {
  const ViewportBox box{draw.viewport.value_or(
      rhi::Viewport{0, 0, float(m_extent.width), float(m_extent.height), 0, 1})};
  if (box != m_viewport) {
    m_gl.ViewportIndexedf(0, box.v.x, box.v.y, box.v.width, box.v.height);
    m_gl.DepthRangef(box.v.minDepth, box.v.maxDepth);
    m_viewport = box;
  }
  enable(GL_SCISSOR_TEST, draw.scissor.has_value(), m_scissor);
  if (!draw.scissor) return;
  const rhi::Rect& r = *draw.scissor;
  if (m_scissorRect && m_scissorRect->x == r.x && m_scissorRect->y == r.y &&
      m_scissorRect->width == r.width && m_scissorRect->height == r.height)
    return;
  m_gl.Scissor(r.x, r.y, GLsizei(r.width), GLsizei(r.height));
  m_scissorRect = r;
}

}  // namespace opengl
