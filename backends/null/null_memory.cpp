#include "backends/null/null_memory.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace null_backend {

Texture::Texture(const rhi::TextureDesc& desc) : m_desc(desc), m_mips(desc.mips) {
  const bool stencil = rhi::formatInfo(desc.format).stencil;
  for (uint32_t mip = 0; mip < desc.mips; ++mip) {
    const size_t texels =
        size_t(std::max(1u, desc.width >> mip)) * std::max(1u, desc.height >> mip) * desc.samples;
    m_mips[mip].resize(slices(mip));
    for (Plane& plane : m_mips[mip]) {
      plane.main.resize(texels * rhi::hostTexelBytes(desc.format, rhi::Aspect::Color));
      if (stencil) plane.stencil.resize(texels);
    }
  }
}

uint32_t Texture::slices(uint32_t mip) const {
  return m_desc.kind == rhi::TextureKind::Tex3D ? std::max(1u, m_desc.depth >> mip) : m_desc.layers;
}

Texture::Plane& Texture::plane(uint32_t mip, uint32_t layer) {
  assert(mip < m_mips.size() && layer < m_mips[mip].size());
  return m_mips[mip][layer];
}
const Texture::Plane& Texture::plane(uint32_t mip, uint32_t layer) const {
  return const_cast<Texture*>(this)->plane(mip, layer);
}

void Texture::store(const rhi::TextureRegion& region, std::span<const std::byte> bytes) {
  const size_t texel = rhi::hostTexelBytes(m_desc.format, rhi::Aspect::Color);
  const size_t pitch = std::max(1u, m_desc.width >> region.mip) * texel;
  const size_t row = region.width * texel;
  std::vector<std::byte>& target = plane(region.mip, region.layer).main;
  for (uint32_t y = 0; y < region.height; ++y)
    std::memcpy(&target[(region.y + y) * pitch + region.x * texel], &bytes[y * row], row);
}

void Texture::load(const rhi::TextureRegion& region, rhi::Aspect aspect,
                   std::span<std::byte> out) const {
  const bool stencil = aspect == rhi::Aspect::Stencil;
  const size_t texel = rhi::hostTexelBytes(m_desc.format, aspect);
  const size_t pitch = std::max(1u, m_desc.width >> region.mip) * texel;
  const size_t row = region.width * texel;
  const Plane& from = plane(region.mip, region.layer);
  const std::vector<std::byte>& source = stencil ? from.stencil : from.main;
  for (uint32_t y = 0; y < region.height; ++y)
    std::memcpy(&out[y * row], &source[(region.y + y) * pitch + region.x * texel], row);
}

void Texture::copyFrom(const Texture& source, uint32_t sourceMip, uint32_t sourceLayer,
                       uint32_t mip, uint32_t layer) {
  Plane& to = plane(mip, layer);
  const Plane& from = source.plane(sourceMip, sourceLayer);
  assert(from.main.size() == to.main.size() && "copies have equal formats and extents");
  to = from;
}

}  // namespace null_backend
