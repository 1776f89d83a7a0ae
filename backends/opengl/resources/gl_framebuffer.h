// Framebuffer objects by what is attached to them, made on first use. A framebuffer goes when one
// of its textures does.
#pragma once

#include <map>
#include <vector>

#include "backends/opengl/resources/gl_objects.h"

namespace opengl {

/// One attachment: a single mip, one layer or a range of layers.
struct AttachmentKey {
  uint32_t texture = 0;  ///< rhi::TextureId::value, 0: none
  uint32_t mip = 0;
  uint32_t baseLayer = 0;
  uint32_t layerCount = 1;
  auto operator<=>(const AttachmentKey&) const = default;
};
struct FramebufferKey {
  std::vector<AttachmentKey> colors;
  AttachmentKey depth;
  uint32_t width = 0, height = 0;  ///< of a framebuffer without attachments
  auto operator<=>(const FramebufferKey&) const = default;
};

class FramebufferCache {
 public:
  FramebufferCache(const Functions& gl, Objects& objects) : m_gl(gl), m_objects(objects) {}

  GLuint get(const FramebufferKey& key);
  AttachmentKey attachment(const rhi::TextureView& view) const;
  /// The framebuffer of a pass, and its size.
  FramebufferKey key(const rhi::PassDesc& pass) const;
  rhi::Extent2D extent(const FramebufferKey& key) const;
  /// Returns the names that were deleted.
  std::vector<GLuint> forget(rhi::TextureId texture);

 private:
  UniqueName create(const FramebufferKey& key);
  void attach(GLuint framebuffer, GLenum point, const AttachmentKey& attachment);

  const Functions& m_gl;
  Objects& m_objects;
  std::map<FramebufferKey, UniqueName> m_framebuffers;
};

}  // namespace opengl
