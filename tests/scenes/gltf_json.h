// Small glTF files as JSON: a triangle to be changed, and files that use one part of the format
// each.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sb::test {

using nlohmann::json;

inline std::string base64(const std::string& bytes) {
  const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t word = 0;
    for (size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? uint8_t(bytes[i + k]) : 0);
    for (size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? letters[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

template <typename T>
std::string bytesOf(const std::vector<T>& values) {
  return std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

/// Adds a buffer, a view of it and an accessor; returns the accessor's index.
inline size_t addAccessor(json& gltf, const std::string& bytes, int componentType,
                          const std::string& type, size_t count) {
  gltf["buffers"].push_back({{"byteLength", bytes.size()},
                             {"uri", "data:application/octet-stream;base64," + base64(bytes)}});
  gltf["bufferViews"].push_back(
      {{"buffer", gltf["buffers"].size() - 1}, {"byteLength", bytes.size()}});
  gltf["accessors"].push_back({{"bufferView", gltf["bufferViews"].size() - 1},
                               {"componentType", componentType},
                               {"count", count},
                               {"type", type}});
  return gltf["accessors"].size() - 1;
}
inline size_t addFloats(json& gltf, const std::vector<float>& values, int components) {
  const std::string type = components == 1 ? "SCALAR" : "VEC" + std::to_string(components);
  return addAccessor(gltf, bytesOf(values), 5126, type, values.size() / size_t(components));
}

/// A sound file that shows the triangle (0,0,0), (1,0,0), (0,1,0).
inline json triangleFile() {
  json gltf = {{"asset", {{"version", "2.0"}}}, {"scene", 0}};
  const size_t positions = addFloats(gltf, {0, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
  gltf["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", positions}}}}}}}};
  gltf["nodes"] = {{{"mesh", 0}}};
  gltf["scenes"] = {{{"nodes", {0}}}};
  return gltf;
}

/// 32-bit indices.
inline size_t addIndices(json& gltf, const std::vector<uint32_t>& indices) {
  return addAccessor(gltf, bytesOf(indices), 5125, "SCALAR", indices.size());
}

/// The triangle with a skin of one joint, which stands at (1, 2, 3) and turns x to y. The node that
/// shows it stands elsewhere, which must not count.
inline json skinnedFile() {
  json gltf = triangleFile();
  json& attributes = gltf["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] =
      addAccessor(gltf, bytesOf<uint8_t>({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), 5121, "VEC4", 3);
  attributes["WEIGHTS_0"] = addFloats(gltf, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 4);
  attributes["NORMAL"] = addFloats(gltf, {0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
  const size_t binds = addAccessor(
      gltf, bytesOf<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}), 5126, "MAT4", 1);
  gltf["skins"] = {{{"joints", {1}}, {"inverseBindMatrices", binds}}};
  gltf["nodes"][0]["skin"] = 0;
  gltf["nodes"][0]["translation"] = {100, 0, 0};
  gltf["nodes"].push_back(
      {{"translation", {1, 2, 3}}, {"rotation", {0, 0, 0.70710678118654752, 0.70710678118654752}}});
  gltf["scenes"][0]["nodes"] = {0, 1};
  return gltf;
}

/// The triangle with two targets that lift it along z by 1 and move it along x by 1; the mesh
/// weighs the first with 0.5.
inline json morphedFile() {
  json gltf = triangleFile();
  json& primitive = gltf["meshes"][0]["primitives"][0];
  primitive["targets"] = {{{"POSITION", addFloats(gltf, {0, 0, 1, 0, 0, 1, 0, 0, 1}, 3)}},
                          {{"POSITION", addFloats(gltf, {1, 0, 0, 1, 0, 0, 1, 0, 0}, 3)}}};
  gltf["meshes"][0]["weights"] = {0.5, 0};
  return gltf;
}

/// The triangle's node animated: first key at 1 s puts it at (5, 6, 7).
inline json animatedFile() {
  json gltf = triangleFile();
  const size_t times = addFloats(gltf, {1, 2}, 1);
  const size_t places = addFloats(gltf, {5, 6, 7, 8, 9, 10}, 3);
  gltf["animations"] = json::parse(R"([{
    "name": "walk",
    "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
    "samplers": [{}]}])");
  gltf["animations"][0]["samplers"][0] = {{"input", times}, {"output", places}};
  return gltf;
}

/// The triangle three times, by EXT_mesh_gpu_instancing.
inline json instancedFile() {
  json gltf = triangleFile();
  const size_t places = addFloats(gltf, {0, 0, 0, 2, 0, 0, 4, 0, 0}, 3);
  const size_t scales = addFloats(gltf, {1, 1, 1, 2, 2, 2, 3, 3, 3}, 3);
  gltf["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  gltf["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  gltf["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
      {"TRANSLATION", places}, {"SCALE", scales}};
  return gltf;
}

/// A camera of each kind and a light of each type.
inline json camerasAndLightsFile() {
  json gltf = triangleFile();
  gltf["cameras"] = json::parse(R"([
    {"name": "front", "type": "perspective",
     "perspective": {"yfov": 0.8, "znear": 0.1, "zfar": 100}},
    {"name": "plan", "type": "orthographic",
     "orthographic": {"xmag": 2, "ymag": 2, "znear": 0, "zfar": 50}}])");
  gltf["extensionsUsed"] = {"KHR_lights_punctual"};
  gltf["extensions"]["KHR_lights_punctual"]["lights"] = json::parse(R"([
    {"type": "directional", "intensity": 3}, {"type": "point", "range": 10},
    {"type": "spot", "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.5}}])");
  for (int i = 0; i < 2; ++i) gltf["nodes"].push_back({{"camera", i}, {"translation", {0, 0, 5}}});
  for (int i = 0; i < 3; ++i) {
    gltf["nodes"].push_back({{"translation", {0, 1, 5}}});
    gltf["nodes"].back()["extensions"]["KHR_lights_punctual"]["light"] = i;
  }
  gltf["scenes"][0]["nodes"] = {0, 1, 2, 3, 4, 5};
  return gltf;
}

}  // namespace sb::test
