// The table of rules and its walker. Paths: "meshes[].primitives[]" is every primitive.
#include "suites/scenes/gltf_check.h"

#include <cmath>
#include <functional>

namespace sb {
namespace {

using nlohmann::json;

enum class Kind { UInt, Number, Bool, String, Object, Numbers, Index, Indices };

struct Rule {
  const char* owner;       ///< objects that hold the property
  const char* key;
  Kind kind;
  bool required = false;
  double low = -INFINITY;  ///< of UInt, Number
  double high = INFINITY;
  const char* target = nullptr;  ///< of Index, Indices: top-level array
  size_t count = 0;              ///< of Numbers: length
};

constexpr bool kRequired = true;
constexpr double kInf = INFINITY;

Rule index(const char* owner, const char* key, const char* target, bool required = false) {
  return {owner, key, Kind::Index, required, 0, kInf, target};
}
Rule indices(const char* owner, const char* key, const char* target, bool required = false) {
  return {owner, key, Kind::Indices, required, 0, kInf, target};
}
Rule numbers(const char* owner, const char* key, size_t count) {
  return {owner, key, Kind::Numbers, false, -kInf, kInf, nullptr, count};
}
Rule unit(const char* owner, const char* key) { return {owner, key, Kind::Number, false, 0, 1}; }
Rule positive(const char* owner, const char* key, bool required = false) {
  return {owner, key, Kind::Number, required, std::numeric_limits<double>::min(), kInf};
}

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

      indices("nodes[]", "children", "nodes"),
      index("nodes[]", "mesh", "meshes"),
      index("nodes[]", "camera", "cameras"),
      numbers("nodes[]", "matrix", 16),
      numbers("nodes[]", "translation", 3),
      numbers("nodes[]", "rotation", 4),
      numbers("nodes[]", "scale", 3),
      {"nodes[]", "name", Kind::String},
      {"nodes[].extensions", "KHR_lights_punctual", Kind::Object},

      {"cameras[]", "type", Kind::String, kRequired},
      positive("cameras[].perspective", "yfov", kRequired),
      positive("cameras[].perspective", "znear", kRequired),
      positive("cameras[].perspective", "zfar"),
      {"cameras[].orthographic", "xmag", Kind::Number, kRequired},
      {"cameras[].orthographic", "ymag", Kind::Number, kRequired},
      {"cameras[].orthographic", "znear", Kind::Number, kRequired, 0},
      positive("cameras[].orthographic", "zfar", kRequired),

      index("images[]", "bufferView", "bufferViews"),
      {"images[]", "uri", Kind::String},
      {"images[]", "mimeType", Kind::String},
      index("textures[]", "sampler", "samplers"),
      index("textures[]", "source", "images"),
      {"samplers[]", "magFilter", Kind::UInt},
      {"samplers[]", "minFilter", Kind::UInt},
      {"samplers[]", "wrapS", Kind::UInt},
      {"samplers[]", "wrapT", Kind::UInt},

      {"materials[]", "name", Kind::String},
      {"materials[]", "alphaMode", Kind::String},
      {"materials[]", "alphaCutoff", Kind::Number, false, 0},
      {"materials[]", "doubleSided", Kind::Bool},
      numbers("materials[]", "emissiveFactor", 3),
      {"materials[]", "pbrMetallicRoughness", Kind::Object},
      numbers("materials[].pbrMetallicRoughness", "baseColorFactor", 4),
      unit("materials[].pbrMetallicRoughness", "metallicFactor"),
      unit("materials[].pbrMetallicRoughness", "roughnessFactor"),
      {"materials[].normalTexture", "scale", Kind::Number},
      unit("materials[].occlusionTexture", "strength"),
      unit("materials[].extensions.KHR_materials_transmission", "transmissionFactor"),
      {"materials[].extensions.KHR_materials_volume", "thicknessFactor", Kind::Number, false, 0},
      positive("materials[].extensions.KHR_materials_volume", "attenuationDistance"),
      numbers("materials[].extensions.KHR_materials_volume", "attenuationColor", 3),
      {"materials[].extensions.KHR_materials_emissive_strength", "emissiveStrength", Kind::Number,
       false, 0},

      {"extensions.KHR_lights_punctual.lights[]", "type", Kind::String, kRequired},
      {"extensions.KHR_lights_punctual.lights[]", "intensity", Kind::Number, false, 0},
      positive("extensions.KHR_lights_punctual.lights[]", "range"),
      numbers("extensions.KHR_lights_punctual.lights[]", "color", 3),
      {"extensions.KHR_lights_punctual.lights[].spot", "innerConeAngle", Kind::Number, false, 0,
       1.5707963267948966},
      {"extensions.KHR_lights_punctual.lights[].spot", "outerConeAngle", Kind::Number, false, 0,
       1.5707963267948966},
  };
  return kRules;
}

// Where textures stand; each may carry KHR_texture_transform.
constexpr const char* kTextureInfos[] = {
    "materials[].pbrMetallicRoughness.baseColorTexture",
    "materials[].pbrMetallicRoughness.metallicRoughnessTexture",
    "materials[].normalTexture",
    "materials[].occlusionTexture",
    "materials[].emissiveTexture",
    "materials[].extensions.KHR_materials_transmission.transmissionTexture",
    "materials[].extensions.KHR_materials_volume.thicknessTexture"};

using Visit = std::function<void(json&, const std::string&)>;

// Calls `visit` with every object that `owner` names. `field` is the path walked so far.
void walk(const GltfSource& source, json& at, std::string_view owner, const std::string& field,
          const Visit& visit) {
  if (!at.is_object())
    source.fail(field.empty() ? "JSON" : field, "is " + shown(at) + ", expected an object");
  if (owner.empty()) return visit(at, field);
  const size_t dot = owner.find('.');
  std::string key(owner.substr(0, dot));
  const std::string_view rest = dot == owner.npos ? std::string_view() : owner.substr(dot + 1);
  const bool array = key.ends_with("[]");
  if (array) key.resize(key.size() - 2);
  const auto found = at.find(key);
  if (found == at.end()) return;
  const std::string path = field.empty() ? key : field + "." + key;
  if (!array) return walk(source, *found, rest, path, visit);
  if (!found->is_array()) source.fail(path, "is " + shown(*found) + ", expected an array");
  for (size_t i = 0; i < found->size(); ++i)
    walk(source, (*found)[i], rest, path + "[" + std::to_string(i) + "]", visit);
}

void checkUInt(const GltfSource& source, json& value, const std::string& field) {
  // Numbers like 2.0 are integers by glTF's rules, but tinygltf wants them written without a point.
  if (value.is_number_float()) {
    const double d = value.get<double>();
    if (d >= 0 && d <= 9007199254740992.0 && std::floor(d) == d) value = uint64_t(d);
  }
  if (!value.is_number_unsigned())
    source.fail(field, "is " + shown(value) + ", expected a whole number >= 0");
  // tinygltf keeps offsets and counts in 32 bits here and there.
  if (value.get<uint64_t>() > kMaxFileBytes)
    source.fail(field, "is " + shown(value) + ", expected at most " +
                           std::to_string(kMaxFileBytes));
}

void checkIndex(const GltfSource& source, json& value, const std::string& field,
                const char* target) {
  checkUInt(source, value, field);
  const auto found = source.json.find(target);
  const size_t size = found == source.json.end() ? 0 : found->size();
  if (value.get<size_t>() >= size)
    source.fail(field, "is " + shown(value) + ", but there " +
                           (size == 1 ? "is 1 entry" : "are " + std::to_string(size) + " entries") +
                           " in '" + target + "'");
}

void checkArray(const GltfSource& source, const json& value, const std::string& field) {
  if (!value.is_array()) source.fail(field, "is " + shown(value) + ", expected an array");
}

void checkValue(const GltfSource& source, const Rule& rule, json& value, const std::string& field) {
  const auto expect = [&](bool right, const char* expected) {
    if (!right) source.fail(field, "is " + shown(value) + ", expected " + expected);
  };
  switch (rule.kind) {
    case Kind::Bool: return expect(value.is_boolean(), "true or false");
    case Kind::String: return expect(value.is_string(), "a string");
    case Kind::Object: return expect(value.is_object(), "an object");
    case Kind::Index: return checkIndex(source, value, field, rule.target);
    case Kind::Indices:
      checkArray(source, value, field);
      for (size_t i = 0; i < value.size(); ++i)
        checkIndex(source, value[i], field + "[" + std::to_string(i) + "]", rule.target);
      return;
    case Kind::Numbers:
      checkArray(source, value, field);
      expect(value.size() == rule.count,
             ("an array of " + std::to_string(rule.count) + " numbers").c_str());
      for (const json& number : value) expect(number.is_number(), "numbers only");
      return;
    case Kind::UInt: checkUInt(source, value, field); break;
    case Kind::Number: expect(value.is_number(), "a number"); break;
  }
  const double number = value.get<double>();
  if (number >= rule.low && number <= rule.high) return;
  const auto text = [](double d) { return shown(json(d)); };
  const bool above = rule.low == std::numeric_limits<double>::min();
  expect(false, (rule.high < kInf ? "from " + text(rule.low) + " to " + text(rule.high)
                 : above          ? std::string("more than 0")
                                  : "at least " + text(rule.low))
                    .c_str());
}

void apply(GltfSource& source, const Rule& rule) {
  walk(source, source.json, rule.owner, "", [&](json& owner, const std::string& field) {
    const std::string path = field.empty() ? rule.key : field + "." + rule.key;
    const auto found = owner.find(rule.key);
    if (found != owner.end()) return checkValue(source, rule, *found, path);
    if (rule.required) source.fail(path, "is missing");
  });
}

void checkTextureInfo(GltfSource& source, const std::string& owner) {
  const std::string transform = owner + ".extensions.KHR_texture_transform";
  apply(source, index(owner.c_str(), "index", "textures", kRequired));
  apply(source, {owner.c_str(), "texCoord", Kind::UInt});
  apply(source, numbers(transform.c_str(), "offset", 2));
  apply(source, numbers(transform.c_str(), "scale", 2));
  apply(source, {transform.c_str(), "rotation", Kind::Number});
  apply(source, {transform.c_str(), "texCoord", Kind::UInt});
}

}  // namespace

void checkGltf(GltfSource& source) {
  for (auto& [key, value] : source.json.items())
    if (value.is_array() && value.empty()) source.warn("'" + key + "' is empty");
  for (const char* key : {"extensionsUsed", "extensionsRequired"})
    if (const auto list = source.json.find(key); list != source.json.end()) {
      checkArray(source, *list, key);
      for (size_t i = 0; i < list->size(); ++i)
        if (!(*list)[i].is_string())
          source.fail(key + ("[" + std::to_string(i) + "]"),
                      "is " + shown((*list)[i]) + ", expected a string");
    }
  // Arrays of which no rule names a required member must still be arrays of objects.
  for (const char* owner : {"scenes[]", "nodes[]", "meshes[]", "materials[]", "textures[]",
                            "images[]", "samplers[]", "meshes[].primitives[]", "skins[]"})
    walk(source, source.json, owner, "", [](json&, const std::string&) {});
  for (const Rule& rule : rules()) apply(source, rule);
  walk(source, source.json, "meshes[]", "", [&](json& mesh, const std::string& field) {
    if (!mesh.contains("primitives")) source.fail(field + ".primitives", "is missing");
  });
  walk(source, source.json, "meshes[].primitives[].attributes", "",
       [&](json& attributes, const std::string& field) {
         for (auto& [key, value] : attributes.items())
           checkIndex(source, value, field + "." + key, "accessors");
       });
  walk(source, source.json, "nodes[].extensions.KHR_lights_punctual", "",
       [&](json& light, const std::string& field) {
         if (!light.contains("light")) source.fail(field + ".light", "is missing");
         checkUInt(source, light["light"], field + ".light");
         const json::json_pointer lights("/extensions/KHR_lights_punctual/lights");
         const size_t count = source.json.contains(lights) ? source.json[lights].size() : 0;
         if (light["light"].get<size_t>() >= count)
           source.fail(field + ".light", "is " + shown(light["light"]) + ", but there are " +
                                             std::to_string(count) + " lights");
       });
  for (const char* owner : kTextureInfos) checkTextureInfo(source, owner);
  checkLayout(source);
}

}  // namespace sb
