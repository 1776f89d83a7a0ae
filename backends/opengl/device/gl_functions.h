// Every OpenGL function this backend calls, in one table per context.
// Not epoxy or a link-time libGL: contexts of EGL and of OSMesa live side by side in one process,
// each with its own entry points, and libOSMesa exports gl* symbols of its own (facts.md).
#pragma once

#define GL_GLEXT_PROTOTYPES  // for the types below; nothing is linked
#include <GL/glcorearb.h>

#include <functional>
#include <string>

namespace opengl {

// One name per function; all are core in OpenGL 4.5, so all are required.
// clang-format off
#define OPENGL_FUNCTIONS(X) \
  X(AttachShader) X(BeginQuery) X(BindBuffer) X(BindBufferRange) X(BindFramebuffer) X(BindImageTexture) \
  X(BindSampler) X(BindTextureUnit) X(BindVertexArray) X(BindVertexBuffer) X(BlendColor) \
  X(BlendEquationSeparatei) X(BlendFuncSeparatei) X(BlitNamedFramebuffer) X(CheckNamedFramebufferStatus) \
  X(ClearNamedBufferSubData) X(ClearNamedFramebufferfi) X(ClearNamedFramebufferfv) X(ClearNamedFramebufferiv) \
  X(ClearNamedFramebufferuiv) X(ClientWaitSync) X(ClipControl) X(ColorMaski) X(CompileShader) \
  X(CopyImageSubData) X(CopyNamedBufferSubData) X(CreateBuffers) X(CreateFramebuffers) \
  X(CreateProgram) X(CreateSamplers) X(CreateShader) X(CreateTextures) \
  X(CreateVertexArrays) X(CullFace) X(DebugMessageCallback) X(DebugMessageControl) X(DeleteBuffers) \
  X(DeleteFramebuffers) X(DeleteProgram) X(DeleteQueries) X(DeleteSamplers) X(DeleteShader) \
  X(DeleteSync) X(DeleteTextures) X(DeleteVertexArrays) X(DepthFunc) X(DepthMask) X(DepthRangef) \
  X(DetachShader) X(Disable) X(DisableVertexAttribArray) X(Disablei) X(DispatchCompute) \
  X(DispatchComputeIndirect) X(DrawArraysInstanced) X(DrawElementsInstancedBaseVertexBaseInstance) \
  X(Enable) X(EnableVertexAttribArray) X(Enablei) X(EndQuery) X(FenceSync) X(Finish) X(Flush) \
  X(FrontFace) X(GenQueries) X(GenTextures) X(GetError) X(GetInteger64v) X(GetIntegerv) X(GetInternalformativ) \
  X(GetNamedBufferSubData) X(GetProgramInfoLog) X(GetProgramiv) X(GetQueryObjectui64v) \
  X(GetQueryiv) X(GetShaderInfoLog) X(GetShaderiv) X(GetString) X(GetStringi) X(GetTextureSubImage) \
  X(InvalidateNamedFramebufferData) X(LinkProgram) X(LogicOp) X(MemoryBarrier) X(MinSampleShading) \
  X(MultiDrawArraysIndirect) X(MultiDrawElementsIndirect) X(NamedBufferStorage) X(NamedBufferSubData) \
  X(NamedFramebufferDrawBuffers) X(NamedFramebufferParameteri) X(NamedFramebufferReadBuffer) \
  X(NamedFramebufferTexture) X(NamedFramebufferTextureLayer) X(ObjectLabel) X(PixelStorei) \
  X(PointParameteri) X(PolygonOffset) X(PopDebugGroup) X(ProvokingVertex) X(PushDebugGroup) \
  X(QueryCounter) X(SamplerParameterf) X(SamplerParameterfv) X(SamplerParameteri) X(Scissor) \
  X(ShaderSource) X(StencilFuncSeparate) X(StencilMask) X(StencilOpSeparate) X(TextureBarrier) \
  X(TextureStorage2D) X(TextureStorage2DMultisample) X(TextureStorage3D) X(TextureStorage3DMultisample) \
  X(TextureSubImage2D) X(TextureSubImage3D) X(TextureView) X(UseProgram) X(VertexAttribBinding) \
  X(VertexAttribFormat) X(VertexAttribIFormat) X(VertexBindingDivisor) X(ViewportIndexedf)
// clang-format on

struct Functions {
#define OPENGL_DECLARE(name) decltype(&::gl##name) name = nullptr;
  OPENGL_FUNCTIONS(OPENGL_DECLARE)
#undef OPENGL_DECLARE
};

/// Throws rhi::Error that names what the driver lacks.
Functions loadFunctions(const std::function<void*(const char*)>& resolve);

/// "GL_INVALID_OPERATION" and the like.
std::string errorName(GLenum code);
/// Drops errors of the past, so that throwOnError speaks of the call before it.
void clearErrors(const Functions& gl);
/// glGetError made into an rhi::Error.
void throwOnError(const Functions& gl, const char* call, const std::string& detail);

}  // namespace opengl
