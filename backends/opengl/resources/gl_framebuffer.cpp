#include "backends/opengl/resources/gl_framebuffer.h"

#include <algorithm>

#include "backends/rhi/error.h"

namespace opengl {
namespace {

std::string statusName(GLenum status) {
  switch (status) {
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
      return "GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT";
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
      return "GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT";
    case GL_FRAMEBUFFER_UNSUPPORTED:
      return "GL_FRAMEBUFFER_UNSUPPORTED";
    case GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE:
      return "GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE";
    case GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS:
      return "GL_FRAMEBUFFER_INCOMPLETE_LAYER_TARGETS";
    default:
      return "framebuffer status " + std::to_string(status);
  }
}

}  // namespace

AttachmentKey FramebufferCache::attachment(const rhi::TextureView& view) const {
  const ViewRange range = m_objects.textures.get(view.texture).resolve(view);
  return {view.texture.value, range.baseMip, range.baseLayer, range.layerCount};
}

FramebufferKey FramebufferCache::key(const rhi::PassDesc& pass) const {
  FramebufferKey key;
  for (const rhi::ColorAttachment& color : pass.colors)
    key.colors.push_back(attachment(color.view));
  if (pass.depth) key.depth = attachment(pass.depth->view);
  if (key.colors.empty() && !pass.depth) {
    key.width = pass.extent.width;
    key.height = pass.extent.height;
  }
  return key;
}

rhi::Extent2D FramebufferCache::extent(const FramebufferKey& key) const {
  const AttachmentKey* any = key.depth.texture ? &key.depth : nullptr;
  if (!key.colors.empty()) any = &key.colors.front();
  if (!any) return {key.width, key.height};
  return m_objects.textures.get({any->texture}).extent(any->mip);
}

GLuint FramebufferCache::get(const FramebufferKey& key) {
  auto it = m_framebuffers.find(key);
  if (it == m_framebuffers.end()) it = m_framebuffers.emplace(key, create(key)).first;
  return it->second.get();
}

void FramebufferCache::attach(GLuint framebuffer, GLenum point, const AttachmentKey& a) {
  Texture& texture = m_objects.textures.get({a.texture});
  if (!texture.isArray()) {
    m_gl.NamedFramebufferTexture(framebuffer, point, texture.name(), GLint(a.mip));
  } else if (a.layerCount == 1) {
    m_gl.NamedFramebufferTextureLayer(framebuffer, point, texture.name(), GLint(a.mip),
                                      GLint(a.baseLayer));
  } else {
    // Layered attachments take all layers of a texture, so a range needs a view of its own.
    const bool all = a.layerCount == texture.layers(a.mip);
    const GLuint name = all ? texture.name()
                            : texture.viewName({0, texture.desc().mips, a.baseLayer, a.layerCount});
    m_gl.NamedFramebufferTexture(framebuffer, point, name, GLint(a.mip));
  }
}

UniqueName FramebufferCache::create(const FramebufferKey& key) {
  GLuint name = 0;
  m_gl.CreateFramebuffers(1, &name);
  UniqueName framebuffer(m_gl, name,
                         [](const Functions& f, GLuint n) { f.DeleteFramebuffers(1, &n); });
  std::vector<GLenum> drawBuffers;
  for (size_t i = 0; i < key.colors.size(); ++i) {
    drawBuffers.push_back(GL_COLOR_ATTACHMENT0 + GLenum(i));
    attach(name, drawBuffers.back(), key.colors[i]);
  }
  m_gl.NamedFramebufferDrawBuffers(name, GLsizei(drawBuffers.size()), drawBuffers.data());
  m_gl.NamedFramebufferReadBuffer(name, key.colors.empty() ? GL_NONE : GL_COLOR_ATTACHMENT0);
  if (key.depth.texture) {
    const auto& desc = m_objects.textures.get({key.depth.texture}).desc();
    attach(name,
           rhi::formatInfo(desc.format).stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
           key.depth);
  } else if (key.colors.empty()) {
    m_gl.NamedFramebufferParameteri(name, GL_FRAMEBUFFER_DEFAULT_WIDTH, GLint(key.width));
    m_gl.NamedFramebufferParameteri(name, GL_FRAMEBUFFER_DEFAULT_HEIGHT, GLint(key.height));
  }
  const GLenum status = m_gl.CheckNamedFramebufferStatus(name, GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    std::string list;
    auto mention = [&](const AttachmentKey& a) {
      const auto& desc = m_objects.textures.get({a.texture}).desc();
      list += (list.empty() ? "'" : ", '") + desc.label + "' " +
              std::string(rhi::formatInfo(desc.format).name);
    };
    for (const AttachmentKey& color : key.colors) mention(color);
    if (key.depth.texture) mention(key.depth);
    throw rhi::Error("glCheckNamedFramebufferStatus", statusName(status), "attachments: " + list);
  }
  return framebuffer;
}

std::vector<GLuint> FramebufferCache::forget(rhi::TextureId texture) {
  std::vector<GLuint> deleted;
  std::erase_if(m_framebuffers, [&](const auto& entry) {
    const FramebufferKey& key = entry.first;
    const bool uses =
        key.depth.texture == texture.value ||
        std::ranges::find(key.colors, texture.value, &AttachmentKey::texture) != key.colors.end();
    if (uses) deleted.push_back(entry.second.get());
    return uses;
  });
  return deleted;
}

}  // namespace opengl
