// The glTF document under construction. Internal to the export.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>
#include <vector>

#include "techniques/scene/scene.h"

namespace sb {

class GltfWriter {
 public:
  explicit GltfWriter(const Scene& scene) : m_scene(scene) {}
  /// The whole file.
  std::vector<uint8_t> write();

 private:
  using json = nlohmann::json;

  // writer.cpp: bytes, geometry, nodes
  size_t addView(const void* data, size_t bytes);
  template <typename V>
  size_t addAccessor(const std::vector<V>& values);
  size_t addIndices(const std::vector<uint32_t>& indices);
  size_t addScalars(const void* data, size_t count, int componentType);
  void addImages();
  size_t meshFor(const Instance& instance);
  size_t addMesh(uint32_t mesh, bool mirrored, double thicknessScale);
  void addInstances();
  void addMedia();
  size_t addNode(json node);
  void use(const char* extension) { m_extensions.insert(extension); }

  // writer_material.cpp
  json textureInfo(const TextureSlot& slot);
  size_t materialFor(uint32_t material, double thicknessScale);
  json materialJson(const Material& material);
  json materialExtensions(const Material& material);

  // writer_lights.cpp
  void addLights();
  void addCameras();

  const Scene& m_scene;
  json m_gltf;
  std::vector<uint8_t> m_bytes;
  std::set<std::string> m_extensions;
  std::map<std::tuple<uint32_t, bool, double>, size_t> m_meshes;
  std::map<std::pair<uint32_t, double>, size_t> m_materials;
  std::map<std::tuple<uint32_t, Wrap, Wrap, bool>, size_t> m_textures;
};

/// A matrix as glTF states it, column by column.
nlohmann::json matrixJson(const glm::dmat4& m);
/// A vector as a JSON array; floats keep their exact value.
template <typename V>
nlohmann::json vectorJson(const V& v) {
  nlohmann::json array = nlohmann::json::array();
  for (int i = 0; i < V::length(); ++i) array.push_back(v[i]);
  return array;
}

}  // namespace sb
