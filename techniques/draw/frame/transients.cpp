#include "techniques/draw/frame/transients.h"

#include <algorithm>

namespace sb {

rhi::TextureId Transients::texture(const rhi::TextureDesc& desc, FramePart part) {
  auto at = std::ranges::find_if(m_textures, [&](const Shared& shared) {
    rhi::TextureDesc there = m_device.textureDesc(shared.texture);
    there.label = desc.label;
    return !shared.taken[size_t(part)] && there == desc;
  });
  if (at == m_textures.end()) at = m_textures.insert(at, {.texture = m_device.createTexture(desc)});
  at->taken[size_t(part)] = true;
  return at->texture;
}

void Transients::begin(rhi::CommandList& commands) const {
  for (const Shared& shared : m_textures) commands.discard(shared.texture);
}

}  // namespace sb
