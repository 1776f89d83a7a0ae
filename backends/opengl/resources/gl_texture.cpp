#include "backends/opengl/resources/gl_texture.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <vector>

#include "backends/opengl/device/gl_debug.h"
#include "backends/opengl/resources/gl_formats.h"

namespace opengl {
namespace {

void destroyTexture(const Functions& gl, GLuint name) { gl.DeleteTextures(1, &name); }

/// Bytes: far below what a signed 32-bit size holds, so that tests reach it too.
constexpr size_t kReadAtOnce = size_t(64) << 20;

// OpenGL passes D24 as a normalised 32-bit integer. Repeating the high bits below makes the
// conversion to 24 bits exact in both directions, whether the driver shifts or rounds.
uint32_t widen24(uint32_t value) { return value << 8 | (value & 0xFFFFFF) >> 16; }

}  // namespace

Texture::Texture(const Functions& gl, const rhi::TextureDesc& desc)
    : m_gl(&gl), m_desc(desc), m_target(textureTarget(desc.kind, desc.samples)) {
  clearErrors(gl);
  GLuint name = 0;
  gl.CreateTextures(m_target, 1, &name);
  m_name = UniqueName(gl, name, destroyTexture);
  const GLenum format = formatTriple(desc.format).internalFormat;
  const auto levels = GLsizei(desc.mips), samples = GLsizei(desc.samples);
  const auto w = GLsizei(desc.width), h = GLsizei(desc.height);
  switch (m_target) {
    case GL_TEXTURE_2D:
      gl.TextureStorage2D(name, levels, format, w, h);
      break;
    case GL_TEXTURE_2D_ARRAY:
      gl.TextureStorage3D(name, levels, format, w, h, GLsizei(desc.layers));
      break;
    case GL_TEXTURE_3D:
      gl.TextureStorage3D(name, levels, format, w, h, GLsizei(desc.depth));
      break;
    case GL_TEXTURE_2D_MULTISAMPLE:
      gl.TextureStorage2DMultisample(name, samples, format, w, h, GL_TRUE);
      break;
    default:
      gl.TextureStorage3DMultisample(name, samples, format, w, h, GLsizei(desc.layers), GL_TRUE);
  }
  throwOnError(gl, "glTextureStorage",
               "texture '" + desc.label + "' of " + std::to_string(desc.width) + "x" +
                   std::to_string(desc.height) + "x" + std::to_string(layers(0)) + " " +
                   std::string(rhi::formatInfo(desc.format).name));
  labelObject(gl, GL_TEXTURE, name, desc.label);
}

rhi::Extent2D Texture::extent(uint32_t mip) const {
  return {std::max(1u, m_desc.width >> mip), std::max(1u, m_desc.height >> mip)};
}

uint32_t Texture::layers(uint32_t mip) const {
  return m_desc.kind == rhi::TextureKind::Tex3D ? std::max(1u, m_desc.depth >> mip) : m_desc.layers;
}

ViewRange Texture::resolve(const rhi::TextureView& view) const {
  ViewRange range{view.baseMip, view.mipCount, view.baseLayer, view.layerCount};
  if (range.mipCount == rhi::kAllRemaining) range.mipCount = m_desc.mips - range.baseMip;
  if (range.layerCount == rhi::kAllRemaining)
    range.layerCount = layers(range.baseMip) - range.baseLayer;
  assert(range.baseMip + range.mipCount <= m_desc.mips);
  assert(range.baseLayer + range.layerCount <= layers(range.baseMip));
  return range;
}

GLuint Texture::viewName(const ViewRange& range) {
  const bool allLayers = m_desc.kind != rhi::TextureKind::Tex2DArray ||
                         (range.baseLayer == 0 && range.layerCount == m_desc.layers);
  if (range.baseMip == 0 && range.mipCount == m_desc.mips && allLayers) return name();
  auto [it, isNew] = m_views.try_emplace(range);
  if (isNew) {
    const bool layered = m_desc.kind == rhi::TextureKind::Tex2DArray;
    GLuint view = 0;
    m_gl->GenTextures(1, &view);
    m_gl->TextureView(view, m_target, name(), formatTriple(m_desc.format).internalFormat,
                      range.baseMip, range.mipCount, layered ? range.baseLayer : 0,
                      layered ? range.layerCount : 1);
    it->second = UniqueName(*m_gl, view, destroyTexture);
    labelObject(*m_gl, GL_TEXTURE, view, m_desc.label + " (view)");
  }
  return it->second.get();
}

bool Texture::isDepth24() const {
  return m_desc.format == rhi::Format::D24Unorm || m_desc.format == rhi::Format::D24UnormS8;
}

void Texture::upload(const rhi::TextureRegion& region, std::span<const std::byte> bytes) {
  assert(m_desc.samples == 1);
  const FormatTriple& f = formatTriple(m_desc.format);
  const void* data = bytes.data();
  std::vector<uint32_t> wide;
  if (isDepth24()) {
    wide.resize(bytes.size() / 4);
    std::memcpy(wide.data(), bytes.data(), bytes.size());
    for (uint32_t& value : wide) value = widen24(value);
    data = wide.data();
  }
  const auto mip = GLint(region.mip), x = GLint(region.x), y = GLint(region.y);
  const auto w = GLsizei(region.width), h = GLsizei(region.height);
  if (isArray())
    m_gl->TextureSubImage3D(name(), mip, x, y, GLint(region.layer), w, h, 1, f.format, f.type,
                            data);
  else
    m_gl->TextureSubImage2D(name(), mip, x, y, w, h, f.format, f.type, data);
}

void Texture::read(const rhi::TextureRegion& region, rhi::Aspect aspect,
                   std::span<std::byte> out) const {
  assert(m_desc.samples == 1);
  FormatTriple f = formatTriple(m_desc.format);
  if (aspect == rhi::Aspect::Stencil) f = {f.internalFormat, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE};
  // Sizes are 32-bit and signed here: rows at a time, as many as fit.
  const size_t row = out.size() / std::max(1u, region.height);
  const uint32_t most = uint32_t(std::clamp<size_t>(kReadAtOnce / std::max<size_t>(1, row), 1,
                                                    std::max(1u, region.height)));
  for (uint32_t y = 0; y < region.height; y += most) {
    const uint32_t rows = std::min(most, region.height - y);
    const std::span<std::byte> part = out.subspan(y * row, rows * row);
    m_gl->GetTextureSubImage(name(), GLint(region.mip), GLint(region.x), GLint(region.y + y),
                             GLint(region.layer), GLsizei(region.width), GLsizei(rows), 1, f.format,
                             f.type, GLsizei(part.size()), part.data());
  }
  if (!isDepth24() || aspect == rhi::Aspect::Stencil) return;
  for (size_t i = 0; i + 4 <= out.size(); i += 4) {
    uint32_t value;
    std::memcpy(&value, &out[i], 4);
    value >>= 8;
    std::memcpy(&out[i], &value, 4);
  }
}

}  // namespace opengl
