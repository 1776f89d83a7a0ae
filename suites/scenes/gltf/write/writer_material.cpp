#include <cmath>

#include "suites/scenes/gltf/write/writer.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

using nlohmann::json;

int wrapCode(Wrap wrap) {
  constexpr int kCodes[] = {10497, 33648, 33071};
  return kCodes[size_t(wrap)];
}

// offset, rotation and scale that give the rows again (see texture.cpp).
json transformJson(const std::array<glm::vec3, 2>& rows) {
  const double sx = std::hypot(rows[0].x, rows[1].x);
  // A scale of 0 along u leaves the turn to be read from v.
  const double turn = sx > 0 ? std::atan2(-double(rows[1].x), double(rows[0].x))
                             : std::atan2(double(rows[0].y), double(rows[1].y));
  const double c = std::cos(turn), s = std::sin(turn);
  const double sy = s * rows[0].y + c * rows[1].y;
  if (std::abs(c * rows[0].y - s * rows[1].y) > 1e-5 * (std::abs(sy) + 1))
    throw InputError("texture transform", "shears, which glTF cannot state");
  return {{"offset", {rows[0].z, rows[1].z}}, {"rotation", turn}, {"scale", {sx, sy}}};
}

}  // namespace

json GltfWriter::textureInfo(const TextureSlot& slot) {
  const auto [found, added] =
      m_textures.try_emplace({slot.image, slot.wrapU, slot.wrapV, slot.nearest}, 0);
  if (added) {
    m_gltf["samplers"].push_back({{"wrapS", wrapCode(slot.wrapU)},
                                  {"wrapT", wrapCode(slot.wrapV)},
                                  {"magFilter", slot.nearest ? 9728 : 9729}});
    m_gltf["textures"].push_back(
        {{"source", slot.image}, {"sampler", m_gltf["samplers"].size() - 1}});
    found->second = m_gltf["textures"].size() - 1;
  }
  json info = {{"index", found->second}};
  if (slot.uvSet != 0) info["texCoord"] = slot.uvSet;
  if (slot.uvTransform != TextureSlot().uvTransform) {
    use("KHR_texture_transform");
    info["extensions"]["KHR_texture_transform"] = transformJson(slot.uvTransform);
  }
  return info;
}

size_t GltfWriter::materialFor(uint32_t index, double thicknessScale) {
  const auto [found, added] = m_materials.try_emplace({index, thicknessScale}, 0);
  if (!added) return found->second;
  Material material = m_scene.materials.at(index);
  material.thickness = float(material.thickness / thicknessScale);
  m_gltf["materials"].push_back(materialJson(material));
  return found->second = m_gltf["materials"].size() - 1;
}

json GltfWriter::materialExtensions(const Material& m) {
  json extensions = json::object();
  const auto extension = [&](const char* name) -> json& {
    use(name);
    return extensions[name] = json::object();
  };
  if (m.unlit) extension("KHR_materials_unlit");
  if (m.transmission > 0) {
    json& e = extension("KHR_materials_transmission");
    e["transmissionFactor"] = m.transmission;
    if (m.transmissionTexture.present())
      e["transmissionTexture"] = textureInfo(m.transmissionTexture);
  }
  if (m.thickness > 0 || std::isfinite(m.attenuationDistance)) {
    json& e = extension("KHR_materials_volume");
    e["thicknessFactor"] = m.thickness;
    e["attenuationColor"] = vectorJson(m.attenuationColor);
    if (std::isfinite(m.attenuationDistance)) e["attenuationDistance"] = m.attenuationDistance;
    if (m.thicknessTexture.present()) e["thicknessTexture"] = textureInfo(m.thicknessTexture);
  }
  return extensions;
}

json GltfWriter::materialJson(const Material& m) {
  json j = {{"name", m.name}};
  json& pbr = j["pbrMetallicRoughness"];
  pbr = {{"baseColorFactor", vectorJson(m.baseColor)},
         {"metallicFactor", m.metallic},
         {"roughnessFactor", m.roughness}};
  if (m.baseColorTexture.present()) pbr["baseColorTexture"] = textureInfo(m.baseColorTexture);
  if (m.metallicRoughnessTexture.present())
    pbr["metallicRoughnessTexture"] = textureInfo(m.metallicRoughnessTexture);
  if (m.normalTexture.present()) {
    j["normalTexture"] = textureInfo(m.normalTexture);
    j["normalTexture"]["scale"] = m.normalScale;
  }
  if (m.occlusionTexture.present()) {
    j["occlusionTexture"] = textureInfo(m.occlusionTexture);
    j["occlusionTexture"]["strength"] = m.occlusionStrength;
  }
  if (m.emissiveTexture.present()) j["emissiveTexture"] = textureInfo(m.emissiveTexture);
  constexpr const char* kModes[] = {"OPAQUE", "MASK", "BLEND"};
  j["alphaMode"] = kModes[size_t(m.alphaMode)];
  if (m.alphaMode == AlphaMode::Mask) j["alphaCutoff"] = m.alphaCutoff;
  j["doubleSided"] = m.doubleSided;
  json extensions = materialExtensions(m);
  const float brightest = std::max({m.emissive.r, m.emissive.g, m.emissive.b});
  // Factors end at 1; a power of two takes the rest without rounding.
  const float strength = brightest > 1 ? std::exp2(std::min(std::ceil(std::log2(brightest)), 127.0f)) : 1.0f;
  if (strength > 1) {
    use("KHR_materials_emissive_strength");
    extensions["KHR_materials_emissive_strength"]["emissiveStrength"] = strength;
  }
  j["emissiveFactor"] = vectorJson(m.emissive / strength);
  if (!extensions.empty()) j["extensions"] = extensions;
  if (m.opticsOverride)
    j["extras"]["shadowbench"] = {{"alpha", m.overrideAlpha},
                                  {"t", vectorJson(m.overrideTransmission)}};
  return j;
}

}  // namespace sb
