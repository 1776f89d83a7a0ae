// The walker of the table of rules (check_rules.cpp).
#include "suites/scenes/gltf/check/check.h"

#include <cmath>
#include <functional>

#include "suites/scenes/gltf/check/check_rules.h"

namespace sb {
namespace {

using nlohmann::json;
using gltf::Kind, gltf::Rule, gltf::index, gltf::number, gltf::numbers;
using gltf::kInf, gltf::kRequired;

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
    source.fail(field,
                "is " + shown(value) + ", expected at most " + std::to_string(kMaxFileBytes));
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
    case Kind::Bool:
      return expect(value.is_boolean(), "true or false");
    case Kind::String:
      return expect(value.is_string(), "a string");
    case Kind::Object:
      return expect(value.is_object(), "an object");
    case Kind::Index:
      return checkIndex(source, value, field, rule.target);
    case Kind::Indices:
      checkArray(source, value, field);
      for (size_t i = 0; i < value.size(); ++i)
        checkIndex(source, value[i], field + "[" + std::to_string(i) + "]", rule.target);
      return;
    case Kind::Numbers:
      checkArray(source, value, field);
      expect(value.size() == rule.count,
             ("an array of " + std::to_string(rule.count) + " numbers").c_str());
      for (const json& n : value) {
        expect(n.is_number(), "numbers only");
        expect(std::abs(n.get<double>()) <= rule.high, "numbers that a 32-bit float can hold");
      }
      return;
    case Kind::UInt:
      checkUInt(source, value, field);
      break;
    case Kind::Number:
      expect(value.is_number(), "a number");
      break;
  }
  const double number = value.get<double>();
  if (number >= rule.low && number <= rule.high) return;
  const auto text = [](double d) {  // whole ones without a point
    return std::floor(d) == d && std::abs(d) < 1e15 ? std::to_string(int64_t(d)) : shown(json(d));
  };
  if (number > rule.high && rule.high == FLT_MAX)
    expect(false, "a number that a 32-bit float can hold");
  const bool above = rule.low == FLT_MIN, open = rule.high >= FLT_MAX;
  expect(false, (above  ? std::string("more than 0")
                 : open ? "at least " + text(rule.low)
                        : "from " + text(rule.low) + " to " + text(rule.high))
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
  apply(source, number(transform.c_str(), "rotation"));
  apply(source, {transform.c_str(), "texCoord", Kind::UInt});
}

// An object whose type names another one that must stand beside it.
void checkTyped(GltfSource& source, const char* owner, const std::vector<std::string>& types,
                const std::vector<std::string>& partners) {
  walk(source, source.json, owner, "", [&](json& object, const std::string& field) {
    const std::string type = object["type"];
    if (std::ranges::find(types, type) == types.end()) {
      std::string expected;
      for (size_t i = 0; i < types.size(); ++i)
        expected += (i == 0 ? "" : i + 1 == types.size() ? " or " : ", ") + types[i];
      source.fail(field + ".type", "is " + shown(object["type"]) + ", expected " + expected);
    }
    if (std::ranges::find(partners, type) == partners.end()) return;
    if (!object.contains(type))
      source.fail(field + "." + type, "is missing, which type \"" + type + "\" asks for");
    if (!object[type].is_object())
      source.fail(field + "." + type, "is " + shown(object[type]) + ", expected an object");
  });
}

void checkVariants(GltfSource& source) {
  checkTyped(source, "cameras[]", {"perspective", "orthographic"}, {"perspective", "orthographic"});
  checkTyped(source, "extensions.KHR_lights_punctual.lights[]", {"directional", "point", "spot"},
             {"spot"});
}

}  // namespace

namespace {

// Memory of the structures themselves: their JSON, tinygltf's copies and ours. Counted before a rule
// walks over them, for an empty object costs three bytes in the file and kilobytes here.
void checkCounts(GltfSource& source) {
  constexpr std::pair<const char*, size_t> kCosts[] = {
      {"accessors", 1500}, {"bufferViews", 1000}, {"buffers", 800},   {"cameras", 1500},
      {"images", 800},     {"materials", 4000},   {"meshes", 1000},   {"nodes", 1500},
      {"samplers", 1000},  {"scenes", 1000},      {"textures", 1200}, {"skins", 800},
      {"animations", 800}};
  const auto count = [&](const std::string& field, const json& list, size_t bytes) {
    if (list.is_array()) source.take(field, list.size(), bytes);
  };
  for (const auto& [key, bytes] : kCosts)
    if (source.json.contains(key)) count(key, source.json[key], bytes);
  const json::json_pointer lights("/extensions/KHR_lights_punctual/lights");
  if (source.json.contains(lights)) count("extensions", source.json[lights], 1200);
  const auto meshes = source.json.find("meshes");
  if (meshes == source.json.end() || !meshes->is_array()) return;
  for (size_t m = 0; m < meshes->size(); ++m)
    if ((*meshes)[m].is_object() && (*meshes)[m].contains("primitives"))
      count("meshes[" + std::to_string(m) + "].primitives", (*meshes)[m]["primitives"], 1500);
}

}  // namespace

size_t checkedIndex(const GltfSource& source, const json& value, const std::string& field,
                    const char* target) {
  json copy = value;
  checkIndex(source, copy, field, target);
  return copy.get<size_t>();
}

void checkGltf(GltfSource& source) {
  refuseOldVersions(source);
  checkCounts(source);
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
  for (const Rule& rule : gltf::rules()) apply(source, rule);
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
  checkVariants(source);
  for (const char* owner : gltf::textureInfos()) checkTextureInfo(source, owner);
  checkLayout(source);
}

}  // namespace sb
