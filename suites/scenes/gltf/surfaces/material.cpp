// Materials as glTF states them; what they do to light is optics(), elsewhere.
#include <cfloat>
#include <cmath>

#include "suites/scenes/gltf/context.h"

namespace sb {
namespace {

using tinygltf::Value;

double number(const Value& object, const char* key, double fallback) {
  return object.Has(key) ? object.Get(key).GetNumberAsDouble() : fallback;
}

glm::vec3 colour(const std::vector<double>& v, glm::vec3 fallback) {
  return v.size() < 3 ? fallback : glm::vec3(float(v[0]), float(v[1]), float(v[2]));
}

// A texture of an extension, which tinygltf leaves as a Value.
TextureSlot extensionSlot(GltfContext& context, const std::string& field, const Value& extension,
                          const char* key, bool srgb = false) {
  if (!extension.Has(key)) return {};
  const Value& info = extension.Get(key);
  tinygltf::ExtensionMap extensions;
  if (info.Has("extensions"))
    for (const auto& [name, value] : info.Get("extensions").Get<Value::Object>())
      extensions[name] = value;
  return readTextureSlot(context, field + "." + key, int(number(info, "index", -1)),
                         int(number(info, "texCoord", 0)), extensions, srgb);
}

void readExtensions(GltfContext& context, const std::string& field,
                    const tinygltf::ExtensionMap& extensions, Material& m) {
  const auto with = [&](const char* name, const auto& read) {
    const auto found = extensions.find(name);
    if (found != extensions.end()) read(found->second, field + ".extensions." + name);
  };
  with("KHR_materials_pbrSpecularGlossiness", [&](const Value& e, const std::string& path) {
    // Of the older model what lies beneath the gloss: its diffuse colour, on no metal.
    m.baseColor = glm::vec4(1);
    if (e.Has("diffuseFactor"))
      for (int i = 0; i < 4; ++i)
        m.baseColor[i] = float(e.Get("diffuseFactor").Get(size_t(i)).GetNumberAsDouble());
    m.baseColorTexture = extensionSlot(context, path, e, "diffuseTexture", true);
    m.metallic = 0;
    m.metallicRoughnessTexture = {};
    m.roughness = 1 - float(number(e, "glossinessFactor", 1));
  });
  with("KHR_materials_unlit", [&](const Value&, const std::string&) { m.unlit = true; });
  with("KHR_materials_emissive_strength", [&](const Value& e, const std::string&) {
    m.emissive *= float(number(e, "emissiveStrength", 1));
    if (!glm::all(glm::lessThanEqual(glm::abs(m.emissive), glm::vec3(FLT_MAX))))
      context.fail(field + ".emissiveFactor",
                   "times emissiveStrength is more than a 32-bit float can hold");
  });
  with("KHR_materials_transmission", [&](const Value& e, const std::string& path) {
    m.transmission = float(number(e, "transmissionFactor", 0));
    m.transmissionTexture = extensionSlot(context, path, e, "transmissionTexture");
  });
  with("KHR_materials_volume", [&](const Value& e, const std::string& path) {
    m.thickness = float(number(e, "thicknessFactor", 0));
    m.thicknessTexture = extensionSlot(context, path, e, "thicknessTexture");
    m.attenuationDistance =
        float(number(e, "attenuationDistance", std::numeric_limits<double>::infinity()));
    if (e.Has("attenuationColor")) {
      const Value& c = e.Get("attenuationColor");
      for (int i = 0; i < 3; ++i)
        m.attenuationColor[i] = float(c.Get(size_t(i)).GetNumberAsDouble());
    }
  });
}

AlphaMode alphaMode(const GltfContext& context, const std::string& field, const std::string& mode) {
  if (mode == "OPAQUE") return AlphaMode::Opaque;
  if (mode == "MASK") return AlphaMode::Mask;
  if (mode == "BLEND") return AlphaMode::Blend;
  context.fail(field, "is '" + mode + "', expected OPAQUE, MASK or BLEND");
}

Material readMaterial(GltfContext& context, const std::string& field,
                      const tinygltf::Material& source) {
  const auto& pbr = source.pbrMetallicRoughness;
  const std::string pbrField = field + ".pbrMetallicRoughness";
  Material m;
  m.name = source.name;
  m.alphaMode = alphaMode(context, field + ".alphaMode", source.alphaMode);
  m.alphaCutoff = float(source.alphaCutoff);
  m.doubleSided = source.doubleSided;
  if (pbr.baseColorFactor.size() == 4)
    m.baseColor = glm::vec4(colour(pbr.baseColorFactor, glm::vec3(1)), pbr.baseColorFactor[3]);
  m.baseColorTexture =
      readTextureSlot(context, pbrField + ".baseColorTexture", pbr.baseColorTexture.index,
                      pbr.baseColorTexture.texCoord, pbr.baseColorTexture.extensions, true);
  m.metallic = float(pbr.metallicFactor);
  m.roughness = float(pbr.roughnessFactor);
  const auto& mr = pbr.metallicRoughnessTexture;
  m.metallicRoughnessTexture = readTextureSlot(context, pbrField + ".metallicRoughnessTexture",
                                               mr.index, mr.texCoord, mr.extensions, false);
  const auto& normal = source.normalTexture;
  m.normalScale = float(normal.scale);
  m.normalTexture = readTextureSlot(context, field + ".normalTexture", normal.index,
                                    normal.texCoord, normal.extensions, false);
  const auto& occlusion = source.occlusionTexture;
  m.occlusionStrength = float(occlusion.strength);
  m.occlusionTexture = readTextureSlot(context, field + ".occlusionTexture", occlusion.index,
                                       occlusion.texCoord, occlusion.extensions, false);
  m.emissive = colour(source.emissiveFactor, glm::vec3(0));
  const auto& emissive = source.emissiveTexture;
  m.emissiveTexture = readTextureSlot(context, field + ".emissiveTexture", emissive.index,
                                      emissive.texCoord, emissive.extensions, true);
  readExtensions(context, field, source.extensions, m);
  readMaterialExtras(context, field, source.extras, m);
  return m;
}

}  // namespace

void readMaterials(GltfContext& context) {
  context.scene.materials.reserve(context.model.materials.size() + 1);
  for (size_t i = 0; i < context.model.materials.size(); ++i)
    context.scene.materials.push_back(
        readMaterial(context, fieldAt("materials", i), context.model.materials[i]));
}

}  // namespace sb
