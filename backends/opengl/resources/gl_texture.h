// A texture with immutable storage, and glTextureView objects for the parts of it that are bound.
// Views are made on first use and live as long as the texture.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <tuple>

#include "backends/opengl/resources/gl_object.h"
#include "backends/rhi/desc.h"

namespace opengl {

/// A TextureView with its "all remaining" resolved.
struct ViewRange {
  uint32_t baseMip = 0;
  uint32_t mipCount = 1;
  uint32_t baseLayer = 0;
  uint32_t layerCount = 1;
  auto operator<=>(const ViewRange&) const = default;
};

class Texture {
 public:
  /// Throws rhi::Error with the label.
  Texture(const Functions& gl, const rhi::TextureDesc& desc);

  const rhi::TextureDesc& desc() const { return m_desc; }
  GLuint name() const { return m_name.get(); }
  GLenum target() const { return m_target; }
  bool isArray() const { return m_desc.kind != rhi::TextureKind::Tex2D; }
  rhi::Extent2D extent(uint32_t mip) const;
  /// Layers of an array or slices of a 3-D texture at a mip.
  uint32_t layers(uint32_t mip) const;

  ViewRange resolve(const rhi::TextureView& view) const;
  /// GL name that shows exactly this range: the texture itself when the range is all of it.
  GLuint viewName(const ViewRange& range);

  void upload(const rhi::TextureRegion& region, std::span<const std::byte> bytes);
  void read(const rhi::TextureRegion& region, rhi::Aspect aspect, std::span<std::byte> out) const;

 private:
  bool isDepth24() const;

  const Functions* m_gl;
  rhi::TextureDesc m_desc;
  GLenum m_target;
  UniqueName m_name;
  std::map<ViewRange, UniqueName> m_views;
};

}  // namespace opengl
