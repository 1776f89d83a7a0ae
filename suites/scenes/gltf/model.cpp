// tinygltf (MIT), compiled here rather than linked: without its image decoder, its file access and
// its habit of throwing from them. It gets JSON that checkGltf() has passed.
// nlohmann/json comes first: inside tinygltf it would be declared hidden.
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#define TINYGLTF_IMPLEMENTATION
#include "suites/scenes/gltf/context.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

// tinygltf keeps whole numbers of extensions and extras in an int, where 4294967295 becomes -1.
void widenIntegers(nlohmann::json& value, bool inside) {
  if (inside && value.is_number_integer()) {
    const double number = value.get<double>();
    if (std::abs(number) > 2147483647.0) value = number;
  }
  if (value.is_object())
    for (auto& [key, member] : value.items())
      widenIntegers(member, inside || key == "extensions" || key == "extras");
  else if (value.is_array())
    for (nlohmann::json& element : value) widenIntegers(element, inside);
}

}  // namespace

tinygltf::Model parseModel(const GltfSource& source) {
  nlohmann::json json = nlohmann::json::object();
  // The others we read ourselves, or not at all; buffers and images may hold megabytes of base64.
  for (const char* key :
       {"asset", "scene", "scenes", "nodes", "meshes", "accessors", "bufferViews", "materials",
        "textures", "samplers", "cameras", "extensions", "extensionsUsed", "extensionsRequired"})
    if (const auto found = source.json.find(key); found != source.json.end()) json[key] = *found;
  widenIntegers(json, false);
  for (auto& mesh : json["meshes"])
    for (auto& primitive : mesh["primitives"])
      primitive.erase("targets"), primitive.erase("indices");
  for (auto& mesh : json["meshes"]) mesh.erase("weights");
  for (auto& node : json["nodes"]) node.erase("weights"), node.erase("skin");
  if (json["meshes"].is_null()) json.erase("meshes");
  if (json["nodes"].is_null()) json.erase("nodes");

  tinygltf::TinyGLTF parser;
  tinygltf::Model model;
  std::string error, warning;
  bool parsed = false;
  try {
    const std::string text = json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    parsed = parser.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                        unsigned(text.size()), "");
  } catch (const std::exception& exception) {
    error = exception.what();
  }
  if (!parsed) source.fail("JSON", "tinygltf: " + (error.empty() ? "cannot be read" : error));
  // tinygltf refuses indices without a bufferView (all zero, or sparse), which glTF allows.
  for (size_t m = 0; m < model.meshes.size(); ++m)
    for (size_t p = 0; p < model.meshes[m].primitives.size(); ++p)
      model.meshes[m].primitives[p].indices =
          source.json["meshes"][m]["primitives"][p].value("indices", -1);
  return model;
}

}  // namespace sb
