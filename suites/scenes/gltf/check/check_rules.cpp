// What checkGltf() asks of each property that is read.
#include "suites/scenes/gltf/check/check_rules.h"

namespace sb::gltf {
namespace {

Rule indices(const char* owner, const char* key, const char* target, bool required = false) {
  return {owner, key, Kind::Indices, required, 0, kInf, target};
}
Rule unit(const char* owner, const char* key) { return {owner, key, Kind::Number, false, 0, 1}; }
Rule positive(const char* owner, const char* key, bool required = false) {
  // Below FLT_MIN a float's reciprocal is infinite.
  return {owner, key, Kind::Number, required, FLT_MIN, FLT_MAX};
}

}  // namespace

const std::vector<Rule>& rules() {
  static const std::vector<Rule> kRules = {
      {"", "asset", Kind::Object, kRequired},
      {"asset", "version", Kind::String, kRequired},
      {"asset", "minVersion", Kind::String},
      index("", "scene", "scenes"),
      indices("scenes[]", "nodes", "nodes"),

      {"buffers[]", "byteLength", Kind::UInt, kRequired, 1},
      {"buffers[]", "uri", Kind::String},
      index("bufferViews[]", "buffer", "buffers", kRequired),
      {"bufferViews[]", "byteOffset", Kind::UInt},
      {"bufferViews[]", "byteLength", Kind::UInt, kRequired, 1},
      {"bufferViews[]", "byteStride", Kind::UInt, false, 4, 252},

      index("bufferViews[].extensions.EXT_meshopt_compression", "buffer", "buffers", kRequired),
      {"bufferViews[].extensions.EXT_meshopt_compression", "byteOffset", Kind::UInt},
      {"bufferViews[].extensions.EXT_meshopt_compression", "byteLength", Kind::UInt, kRequired, 1},
      {"bufferViews[].extensions.EXT_meshopt_compression", "byteStride", Kind::UInt, kRequired, 2,
       256},
      {"bufferViews[].extensions.EXT_meshopt_compression", "count", Kind::UInt, kRequired, 1},
      {"bufferViews[].extensions.EXT_meshopt_compression", "mode", Kind::String, kRequired},
      {"bufferViews[].extensions.EXT_meshopt_compression", "filter", Kind::String},

      index("accessors[]", "bufferView", "bufferViews"),
      {"accessors[]", "byteOffset", Kind::UInt},
      {"accessors[]", "componentType", Kind::UInt, kRequired, 5120, 5126},
      {"accessors[]", "count", Kind::UInt, kRequired, 1},
      {"accessors[]", "type", Kind::String, kRequired},
      {"accessors[]", "normalized", Kind::Bool},
      {"accessors[]", "sparse", Kind::Object},
      {"accessors[].sparse", "count", Kind::UInt, kRequired, 1},
      {"accessors[].sparse", "indices", Kind::Object, kRequired},
      {"accessors[].sparse", "values", Kind::Object, kRequired},
      index("accessors[].sparse.indices", "bufferView", "bufferViews", kRequired),
      {"accessors[].sparse.indices", "byteOffset", Kind::UInt},
      {"accessors[].sparse.indices", "componentType", Kind::UInt, kRequired, 5121, 5125},
      index("accessors[].sparse.values", "bufferView", "bufferViews", kRequired),
      {"accessors[].sparse.values", "byteOffset", Kind::UInt},

      {"meshes[].primitives[]", "attributes", Kind::Object, kRequired},
      index("meshes[].primitives[]", "indices", "accessors"),
      index("meshes[].primitives[]", "material", "materials"),
      {"meshes[].primitives[]", "mode", Kind::UInt, false, 0, 6},
      {"meshes[].primitives[].extensions", "KHR_draco_mesh_compression", Kind::Object},
      index("meshes[].primitives[].extensions.KHR_draco_mesh_compression", "bufferView",
            "bufferViews", kRequired),
      {"meshes[].primitives[].extensions.KHR_draco_mesh_compression", "attributes", Kind::Object,
       kRequired},

      indices("nodes[]", "children", "nodes"),
      index("nodes[]", "mesh", "meshes"),
      index("nodes[]", "camera", "cameras"),
      numbers("nodes[]", "matrix", 16, DBL_MAX),
      numbers("nodes[]", "translation", 3, DBL_MAX),
      numbers("nodes[]", "rotation", 4, DBL_MAX),
      numbers("nodes[]", "scale", 3, DBL_MAX),
      {"nodes[]", "name", Kind::String},
      {"nodes[].extensions", "KHR_lights_punctual", Kind::Object},
      {"nodes[].extensions.KHR_node_visibility", "visible", Kind::Bool},
      {"nodes[].extensions", "EXT_mesh_gpu_instancing", Kind::Object},
      {"nodes[].extensions.EXT_mesh_gpu_instancing", "attributes", Kind::Object, kRequired},

      {"cameras[]", "type", Kind::String, kRequired},
      positive("cameras[].perspective", "yfov", kRequired),
      positive("cameras[].perspective", "znear", kRequired),
      positive("cameras[].perspective", "zfar"),
      {"cameras[].orthographic", "xmag", Kind::Number, kRequired, -FLT_MAX, FLT_MAX},
      {"cameras[].orthographic", "ymag", Kind::Number, kRequired, -FLT_MAX, FLT_MAX},
      {"cameras[].orthographic", "znear", Kind::Number, kRequired, 0, FLT_MAX},
      positive("cameras[].orthographic", "zfar", kRequired),

      index("images[]", "bufferView", "bufferViews"),
      {"images[]", "uri", Kind::String},
      {"images[]", "mimeType", Kind::String},
      index("textures[]", "sampler", "samplers"),
      index("textures[].extensions.EXT_texture_webp", "source", "images"),
      index("textures[]", "source", "images"),
      {"samplers[]", "magFilter", Kind::UInt},
      {"samplers[]", "minFilter", Kind::UInt},
      {"samplers[]", "wrapS", Kind::UInt},
      {"samplers[]", "wrapT", Kind::UInt},

      {"materials[]", "name", Kind::String},
      {"materials[]", "alphaMode", Kind::String},
      number("materials[]", "alphaCutoff", 0),
      {"materials[]", "doubleSided", Kind::Bool},
      numbers("materials[]", "emissiveFactor", 3),
      {"materials[]", "pbrMetallicRoughness", Kind::Object},
      numbers("materials[].pbrMetallicRoughness", "baseColorFactor", 4),
      unit("materials[].pbrMetallicRoughness", "metallicFactor"),
      unit("materials[].pbrMetallicRoughness", "roughnessFactor"),
      number("materials[].normalTexture", "scale"),
      unit("materials[].occlusionTexture", "strength"),
      unit("materials[].extensions.KHR_materials_transmission", "transmissionFactor"),
      number("materials[].extensions.KHR_materials_volume", "thicknessFactor", 0),
      positive("materials[].extensions.KHR_materials_volume", "attenuationDistance"),
      numbers("materials[].extensions.KHR_materials_volume", "attenuationColor", 3),
      numbers("materials[].extensions.KHR_materials_pbrSpecularGlossiness", "diffuseFactor", 4),
      unit("materials[].extensions.KHR_materials_pbrSpecularGlossiness", "glossinessFactor"),
      number("materials[].extensions.KHR_materials_emissive_strength", "emissiveStrength", 0),

      {"extensions.KHR_lights_punctual.lights[]", "type", Kind::String, kRequired},
      number("extensions.KHR_lights_punctual.lights[]", "intensity", 0),
      positive("extensions.KHR_lights_punctual.lights[]", "range"),
      numbers("extensions.KHR_lights_punctual.lights[]", "color", 3),
      {"extensions.KHR_lights_punctual.lights[].spot", "innerConeAngle", Kind::Number, false, 0,
       1.5707963267948966},
      {"extensions.KHR_lights_punctual.lights[].spot", "outerConeAngle", Kind::Number, false, 0,
       1.5707963267948966},
  };
  return kRules;
}

std::span<const char* const> textureInfos() {
  static constexpr const char* kTextureInfos[] = {
      "materials[].pbrMetallicRoughness.baseColorTexture",
      "materials[].extensions.KHR_materials_pbrSpecularGlossiness.diffuseTexture",
      "materials[].pbrMetallicRoughness.metallicRoughnessTexture",
      "materials[].normalTexture",
      "materials[].occlusionTexture",
      "materials[].emissiveTexture",
      "materials[].extensions.KHR_materials_transmission.transmissionTexture",
      "materials[].extensions.KHR_materials_volume.thicknessTexture"};
  return kTextureInfos;
}

}  // namespace sb::gltf
