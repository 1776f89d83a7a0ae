// Compressed glTF files, packed with the libraries that the formats come from.
#pragma once

#include <draco/compression/expert_encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>
#include <webp/encode.h>

#include "tests/scenes/gltf_json.h"

namespace sb::test {

inline void require(json& gltf, const char* extension) {
  gltf["extensionsUsed"].push_back(extension);
  gltf["extensionsRequired"].push_back(extension);
}

/// The triangle with packed positions and indices, and a fallback buffer without data.
inline json meshoptFile() {
  json gltf = triangleFile();
  const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::vector<uint32_t> indices = {0, 1, 2};
  std::vector<unsigned char> vertices(meshopt_encodeVertexBufferBound(3, 12));
  vertices.resize(
      meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), positions.data(), 3, 12));
  std::vector<unsigned char> corners(meshopt_encodeIndexBufferBound(3, 3));
  corners.resize(meshopt_encodeIndexBuffer(corners.data(), corners.size(), indices.data(), 3));
  gltf["buffers"] = json::array({{{"byteLength", 1000}}});
  gltf["bufferViews"] = gltf["accessors"] = json::array();
  const auto add = [&](const std::vector<unsigned char>& bytes, size_t stride, const char* mode,
                       int componentType, const char* type) {
    gltf["buffers"].push_back(
        {{"byteLength", bytes.size()},
         {"uri", "data:application/octet-stream;base64," + base64({bytes.begin(), bytes.end()})}});
    gltf["bufferViews"].push_back({{"buffer", 0}, {"byteLength", 3 * stride}});
    gltf["bufferViews"].back()["extensions"]["EXT_meshopt_compression"] = {
        {"buffer", gltf["buffers"].size() - 1},
        {"byteLength", bytes.size()},
        {"byteStride", stride},
        {"count", 3},
        {"mode", mode}};
    gltf["accessors"].push_back({{"bufferView", gltf["bufferViews"].size() - 1},
                                 {"componentType", componentType},
                                 {"count", 3},
                                 {"type", type}});
  };
  add(vertices, 12, "ATTRIBUTES", 5126, "VEC3");
  add(corners, 4, "TRIANGLES", 5125, "SCALAR");
  gltf["meshes"][0]["primitives"][0]["indices"] = 1;
  require(gltf, "EXT_meshopt_compression");
  return gltf;
}

/// A square of two triangles, packed by draco.
inline json dracoFile() {
  json gltf = triangleFile();
  const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(2);
  const int id = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  builder.SetAttributeValuesForFace(id, draco::FaceIndex(0), corners[0], corners[1], corners[2]);
  builder.SetAttributeValuesForFace(id, draco::FaceIndex(1), corners[0], corners[2], corners[3]);
  const auto mesh = builder.Finalize();
  draco::ExpertEncoder encoder(*mesh);
  draco::EncoderBuffer packed;
  encoder.EncodeToBuffer(&packed);
  const size_t view = addAccessor(gltf, {packed.data(), packed.size()}, 5121, "SCALAR", 1);
  gltf["accessors"] = {{{"componentType", 5126}, {"count", 4}, {"type", "VEC3"}},
                       {{"componentType", 5123}, {"count", 6}, {"type", "SCALAR"}}};
  json& primitive = gltf["meshes"][0]["primitives"][0];
  primitive["attributes"]["POSITION"] = 0;
  primitive["indices"] = 1;
  primitive["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", view}, {"attributes", {{"POSITION", mesh->attribute(0)->unique_id()}}}};
  require(gltf, "KHR_draco_mesh_compression");
  return gltf;
}

/// The triangle with a red WebP picture of 4 x 4 as base colour.
inline json webpFile() {
  json gltf = triangleFile();
  std::vector<uint8_t> pixels(4 * 4 * 4);
  for (size_t i = 0; i < pixels.size(); i += 4) pixels[i] = pixels[i + 3] = 255;
  uint8_t* packed = nullptr;
  const size_t size = WebPEncodeLosslessRGBA(pixels.data(), 4, 4, 16, &packed);
  const std::string bytes(reinterpret_cast<char*>(packed), size);
  WebPFree(packed);
  gltf["images"] = {{{"uri", "data:image/webp;base64," + base64(bytes)}}};
  gltf["textures"] = {{{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}}};
  gltf["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  gltf["meshes"][0]["primitives"][0]["material"] = 0;
  gltf["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
      addFloats(gltf, {0, 0, 1, 0, 0, 1}, 2);
  require(gltf, "EXT_texture_webp");
  return gltf;
}

}  // namespace sb::test
