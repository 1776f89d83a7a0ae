// Contents of the null device's buffers and textures in host memory.
#pragma once

#include <span>
#include <vector>

#include "backends/rhi/desc.h"

namespace null_backend {

struct Buffer {
  rhi::BufferDesc desc;
  std::vector<std::byte> bytes;
};

/// Colour or depth texels and stencil texels apart, as uploads and reads see them.
class Texture {
 public:
  explicit Texture(const rhi::TextureDesc& desc);

  const rhi::TextureDesc& desc() const { return m_desc; }
  void store(const rhi::TextureRegion& region, std::span<const std::byte> bytes);
  void load(const rhi::TextureRegion& region, rhi::Aspect aspect, std::span<std::byte> out) const;
  /// All texels of one mip and layer (or z slice), of every aspect.
  void copyFrom(const Texture& source, uint32_t sourceMip, uint32_t sourceLayer, uint32_t mip,
                uint32_t layer);
  uint32_t slices(uint32_t mip) const;

 private:
  struct Plane {
    std::vector<std::byte> main;
    std::vector<std::byte> stencil;
  };
  Plane& plane(uint32_t mip, uint32_t layer);
  const Plane& plane(uint32_t mip, uint32_t layer) const;

  rhi::TextureDesc m_desc;
  std::vector<std::vector<Plane>> m_mips;  // by mip, then layer or z
};

}  // namespace null_backend
