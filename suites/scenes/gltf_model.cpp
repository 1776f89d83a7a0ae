// tinygltf (MIT), compiled here rather than linked: without its image decoder, its file access and
// its habit of throwing from them. It gets JSON that checkGltf() has passed.
// nlohmann/json comes first: inside tinygltf it would be declared hidden.
#include <fstream>
#include <nlohmann/json.hpp>

#define TINYGLTF_IMPLEMENTATION
#include "suites/scenes/gltf_context.h"
#include "techniques/common/error.h"

namespace sb {

tinygltf::Model parseModel(const GltfSource& source) {
  nlohmann::json json = source.json;
  // We read these ourselves, or not at all.
  for (const char* key : {"buffers", "images", "animations", "skins"}) json.erase(key);
  for (auto& mesh : json["meshes"])
    for (auto& primitive : mesh["primitives"]) primitive.erase("targets"), primitive.erase("indices");
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
