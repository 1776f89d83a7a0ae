#include "backends/opengl/resources/gl_sampler.h"

#include "backends/opengl/device/gl_debug.h"
#include "backends/opengl/resources/gl_formats.h"

namespace opengl {
namespace {

GLenum minFilter(const rhi::SamplerDesc& desc) {
  const bool linear = desc.filter == rhi::Filter::Linear;
  // Without mipmapping the driver need not compute a level of detail: same texels, less work.
  if (desc.maxLod <= 0) return linear ? GL_LINEAR : GL_NEAREST;
  if (desc.mipFilter == rhi::Filter::Linear)
    return linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_LINEAR;
  return linear ? GL_LINEAR_MIPMAP_NEAREST : GL_NEAREST_MIPMAP_NEAREST;
}

}  // namespace

Sampler::Sampler(const Functions& gl, const rhi::SamplerDesc& desc) {
  GLuint name = 0;
  gl.CreateSamplers(1, &name);
  m_name = UniqueName(gl, name, [](const Functions& f, GLuint n) { f.DeleteSamplers(1, &n); });
  auto set = [&](GLenum parameter, GLenum value) {
    gl.SamplerParameteri(name, parameter, GLint(value));
  };
  set(GL_TEXTURE_MIN_FILTER, minFilter(desc));
  set(GL_TEXTURE_MAG_FILTER, desc.filter == rhi::Filter::Linear ? GL_LINEAR : GL_NEAREST);
  set(GL_TEXTURE_WRAP_S, addressMode(desc.addressU));
  set(GL_TEXTURE_WRAP_T, addressMode(desc.addressV));
  set(GL_TEXTURE_WRAP_R, addressMode(desc.addressW));
  gl.SamplerParameterf(name, GL_TEXTURE_MIN_LOD, 0);
  gl.SamplerParameterf(name, GL_TEXTURE_MAX_LOD, desc.maxLod);
  const float value = desc.border == rhi::BorderColor::OpaqueWhite ? 1.0f : 0.0f;
  const float border[4] = {value, value, value, value};
  gl.SamplerParameterfv(name, GL_TEXTURE_BORDER_COLOR, border);
  if (desc.compare) {
    set(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    set(GL_TEXTURE_COMPARE_FUNC, compareOp(*desc.compare));
  }
  labelObject(gl, GL_SAMPLER, name, desc.label);
}

}  // namespace opengl
