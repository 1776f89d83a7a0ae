#include <algorithm>

#include "backends/opengl/device/gl_context_egl.h"
#include "backends/opengl/pipeline/gl_program.h"
#include "backends/opengl/resources/gl_formats.h"
#include "tests/baseline/by_hand.h"

namespace sb::baseline {
namespace {

using opengl::Functions;

class OpenglFrame final : public ByHand {
 public:
  explicit OpenglFrame(const Capture& capture)
      : m_capture(capture),
        m_context(opengl::makeEglPlatform()->createContext(0, false)),
        m_gl(m_context->use()) {
    // One clip space and one memory layout for both APIs.
    m_gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    m_gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    m_gl.Disable(GL_DITHER);
    for (const auto& [id, b] : capture.buffers) m_buffers[id] = createBuffer(b);
    for (const auto& [id, t] : capture.textures) m_textures[id] = createTexture(t);
    m_gl.CreateSamplers(1, &m_sampler);  // lookups fetch texels: no filter matters
    for (const auto& [id, p] : capture.pipelines) m_pipelines[id] = createPipeline(p);
    for (const CapturedPass& pass : capture.passes) m_framebuffers.push_back(createTargets(pass));
    m_gl.Finish();
  }

  void submit() override {
    m_context->use();
    for (size_t i = 0; i < m_capture.passes.size(); ++i)
      drawPass(m_capture.passes[i], m_framebuffers[i]);
    m_gl.Flush();
  }

  void wait() override { m_context->use().Finish(); }

  std::vector<std::byte> picture() override {
    m_context->use();
    const rhi::TextureDesc& desc = m_capture.textures.at(m_capture.picture);
    std::vector<std::byte> bytes(size_t(desc.width) * desc.height * 8);
    m_gl.GetTextureSubImage(m_textures.at(m_capture.picture), 0, 0, 0, 0, GLsizei(desc.width),
                            GLsizei(desc.height), 1, GL_RGBA, GL_HALF_FLOAT, GLsizei(bytes.size()),
                            bytes.data());
    return bytes;
  }

 private:
  struct Pipeline {
    opengl::UniqueName program;
    GLuint vertexArray = 0;
    uint64_t slots = 0;  ///< that the shaders use
  };

  GLuint createBuffer(const CapturedBuffer& buffer) {
    GLuint name = 0;
    m_gl.CreateBuffers(1, &name);
    m_gl.NamedBufferStorage(name, GLsizeiptr(buffer.bytes.size()), buffer.bytes.data(), 0);
    return name;
  }

  GLuint createTexture(const rhi::TextureDesc& desc) {
    const GLenum format = opengl::formatTriple(desc.format).internalFormat;
    GLuint name = 0;
    m_gl.CreateTextures(opengl::textureTarget(desc.kind, 1), 1, &name);
    if (desc.kind == rhi::TextureKind::Tex2DArray)
      m_gl.TextureStorage3D(name, 1, format, GLsizei(desc.width), GLsizei(desc.height),
                            GLsizei(desc.layers));
    else
      m_gl.TextureStorage2D(name, 1, format, GLsizei(desc.width), GLsizei(desc.height));
    return name;
  }

  Pipeline createPipeline(const rhi::GraphicsPipelineDesc& desc) {
    std::vector<const rhi::ShaderCode*> stages = {desc.vertex};
    if (desc.fragment) stages.push_back(desc.fragment);
    Pipeline pipeline{opengl::linkProgram(m_gl, desc.label, stages, desc.constants)};
    for (const rhi::ShaderCode* stage : stages)
      for (const rhi::ShaderResource& r : stage->resources) pipeline.slots |= uint64_t(1) << r.slot;
    m_gl.CreateVertexArrays(1, &pipeline.vertexArray);
    m_gl.BindVertexArray(pipeline.vertexArray);
    for (const rhi::VertexAttribute& a : desc.attributes) {
      const opengl::VertexFormatInfo f = opengl::vertexFormat(a.format);
      m_gl.EnableVertexAttribArray(a.location);
      if (f.integer)
        m_gl.VertexAttribIFormat(a.location, f.components, f.type, a.offset);
      else
        m_gl.VertexAttribFormat(a.location, f.components, f.type, GLboolean(f.normalized),
                                a.offset);
      m_gl.VertexAttribBinding(a.location, a.buffer);
    }
    for (GLuint i = 0; i < desc.vertexBuffers.size(); ++i)
      m_gl.VertexBindingDivisor(i, desc.vertexBuffers[i].perInstance ? 1 : 0);
    return pipeline;
  }

  GLuint createTargets(const CapturedPass& pass) {
    GLuint name = 0;
    m_gl.CreateFramebuffers(1, &name);
    auto attach = [&](GLenum point, const rhi::TextureView& view) {
      const GLuint texture = m_textures.at(view.texture);
      if (m_capture.textures.at(view.texture).kind == rhi::TextureKind::Tex2DArray)
        m_gl.NamedFramebufferTextureLayer(name, point, texture, 0, GLint(view.baseLayer));
      else
        m_gl.NamedFramebufferTexture(name, point, texture, 0);
    };
    const GLenum color = pass.colors.empty() ? GL_NONE : GL_COLOR_ATTACHMENT0;
    if (!pass.colors.empty()) attach(GL_COLOR_ATTACHMENT0, pass.colors[0].view);
    m_gl.NamedFramebufferDrawBuffers(name, 1, &color);
    if (pass.depth) attach(GL_DEPTH_ATTACHMENT, pass.depth->view);
    return name;
  }

  void drawPass(const CapturedPass& pass, GLuint framebuffer) {
    m_gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    m_gl.DepthMask(GL_TRUE);
    if (!pass.colors.empty() && pass.colors[0].load == rhi::LoadOp::Clear)
      m_gl.ClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, pass.colors[0].clear.data());
    if (pass.depth && pass.depth->load == rhi::LoadOp::Clear)
      m_gl.ClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &pass.depth->clearDepth);
    const rhi::TextureView& any = pass.colors.empty() ? pass.depth->view : pass.colors[0].view;
    const rhi::TextureDesc& target = m_capture.textures.at(any.texture);
    m_gl.ViewportIndexedf(0, 0, 0, float(target.width), float(target.height));
    for (size_t i = 0; i < pass.draws.size(); ++i) {
      const CapturedDraw& draw = pass.draws[i];
      const CapturedDraw* before = i > 0 ? &pass.draws[i - 1] : nullptr;
      const bool samePipeline = before && before->pipeline == draw.pipeline;
      if (!samePipeline) usePipeline(draw);
      const uint64_t slots = m_pipelines.at(draw.pipeline).slots;
      for (size_t b = 0; b < draw.bindings.size(); ++b)
        if ((slots >> draw.bindings[b].slot & 1) &&
            !(samePipeline && draw.bindings[b] == before->bindings[b]))
          bind(draw.bindings[b]);
      m_gl.DrawElementsInstancedBaseVertexBaseInstance(
          GL_TRIANGLES, GLsizei(draw.args.indexCount), GL_UNSIGNED_INT,
          reinterpret_cast<const void*>(uintptr_t(draw.args.firstIndex) * 4), 1,
          draw.args.vertexOffset, draw.args.firstInstance);
    }
  }

  void usePipeline(const CapturedDraw& draw) {
    const rhi::GraphicsPipelineDesc& desc = m_capture.pipelines.at(draw.pipeline);
    const Pipeline& pipeline = m_pipelines.at(draw.pipeline);
    m_gl.UseProgram(pipeline.program.get());
    m_gl.BindVertexArray(pipeline.vertexArray);
    for (GLuint i = 0; i < draw.vertexBuffers.size(); ++i)
      m_gl.BindVertexBuffer(i, m_buffers.at(draw.vertexBuffers[i].buffer), 0,
                            GLsizei(desc.vertexBuffers[i].stride));
    m_gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_buffers.at(draw.indexBuffer));
    auto set = [&](GLenum what, bool on) { (on ? m_gl.Enable : m_gl.Disable)(what); };
    set(GL_CULL_FACE, desc.raster.cull != rhi::CullMode::None);
    m_gl.CullFace(desc.raster.cull == rhi::CullMode::Front ? GL_FRONT : GL_BACK);
    set(GL_DEPTH_CLAMP, desc.raster.depthClamp);
    set(GL_DEPTH_TEST, desc.depth.test);
    m_gl.DepthMask(GLboolean(desc.depth.write));
    m_gl.DepthFunc(opengl::compareOp(desc.depth.compare));
    if (desc.targets.empty()) return;
    const rhi::BlendState& blend = desc.targets[0].blend;
    (blend.enabled ? m_gl.Enablei : m_gl.Disablei)(GL_BLEND, 0);
    m_gl.BlendFuncSeparatei(
        0, opengl::blendFactor(blend.srcColor), opengl::blendFactor(blend.dstColor),
        opengl::blendFactor(blend.srcAlpha), opengl::blendFactor(blend.dstAlpha));
  }

  void bind(const rhi::Binding& b) {
    if (b.slot >= rhi::kTextureSlotBase) {
      m_gl.BindTextureUnit(b.slot - rhi::kTextureSlotBase, m_textures.at(b.view.texture));
      m_gl.BindSampler(b.slot - rhi::kTextureSlotBase, m_sampler);
      return;
    }
    const bool uniform = b.slot < rhi::kStorageSlotBase;
    const uint64_t size =
        b.size == rhi::kWholeSize ? m_capture.buffers.at(b.buffer).bytes.size() : b.size;
    m_gl.BindBufferRange(uniform ? GL_UNIFORM_BUFFER : GL_SHADER_STORAGE_BUFFER,
                         b.slot - (uniform ? rhi::kUniformSlotBase : rhi::kStorageSlotBase),
                         m_buffers.at(b.buffer), GLintptr(b.offset), GLsizeiptr(size));
  }

  const Capture& m_capture;
  std::unique_ptr<opengl::Context> m_context;
  const Functions& m_gl;
  GLuint m_sampler = 0;  // names go with the context
  IdMap<rhi::BufferId, GLuint> m_buffers;
  IdMap<rhi::TextureId, GLuint> m_textures;
  IdMap<rhi::PipelineId, Pipeline> m_pipelines;
  std::vector<GLuint> m_framebuffers;  ///< by pass
};

}  // namespace

std::unique_ptr<ByHand> makeOpengl(const Capture& capture) {
  return std::make_unique<OpenglFrame>(capture);
}

}  // namespace sb::baseline
