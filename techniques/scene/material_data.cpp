#include "techniques/scene/material_data.h"

#include <cmath>

namespace sb {

const TextureSlot& textureSlot(const Material& m, uint32_t index) {
  switch (index) {
    case TEXTURE_BASE_COLOR: return m.baseColorTexture;
    case TEXTURE_METALLIC_ROUGHNESS: return m.metallicRoughnessTexture;
    case TEXTURE_NORMAL: return m.normalTexture;
    case TEXTURE_OCCLUSION: return m.occlusionTexture;
    case TEXTURE_EMISSIVE: return m.emissiveTexture;
    case TEXTURE_TRANSMISSION: return m.transmissionTexture;
    default: return m.thicknessTexture;
  }
}

gpu::MaterialData materialData(const Material& m) {
  gpu::MaterialData d{};
  d.baseColor = m.baseColor;
  d.emissiveCutoff = glm::vec4(m.emissive, m.alphaCutoff);
  d.surface = glm::vec4(m.metallic, m.roughness, m.normalScale, m.occlusionStrength);
  const bool absorbs = std::isfinite(m.attenuationDistance) && m.attenuationDistance > 0;
  d.transmission = glm::vec4(m.transmission, m.thickness, absorbs ? 1 / m.attenuationDistance : 0, 0);
  d.attenuation = glm::vec4(m.attenuationColor, 0);
  d.overrideOptics = glm::clamp(glm::vec4(m.overrideTransmission, m.overrideAlpha), 0.0f, 1.0f);
  d.flags.x = (m.alphaMode == AlphaMode::Mask ? MATERIAL_MASK : 0) |
              (m.alphaMode == AlphaMode::Blend ? MATERIAL_BLEND : 0) |
              (m.doubleSided ? MATERIAL_DOUBLE_SIDED : 0) | (m.unlit ? MATERIAL_UNLIT : 0) |
              (m.transmission > 0 ? MATERIAL_TRANSMISSION : 0) |
              (m.opticsOverride ? MATERIAL_OVERRIDE : 0);
  for (uint32_t i = 0; i < MATERIAL_TEXTURES; ++i) {
    const TextureSlot& slot = textureSlot(m, i);
    d.flags.y |= slot.present() ? 1u << i : 0;
    d.flags.z |= slot.uvSet == 1 ? 1u << i : 0;
    d.uvRows[2 * i] = glm::vec4(slot.uvTransform[0], 0);
    d.uvRows[2 * i + 1] = glm::vec4(slot.uvTransform[1], 0);
  }
  return d;
}

}  // namespace sb
