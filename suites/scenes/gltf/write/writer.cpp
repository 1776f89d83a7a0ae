#include "suites/scenes/gltf/write/writer.h"

#include <cmath>
#include <cstring>

#include "suites/scenes/edit/mesh_tools.h"
#include "suites/scenes/gltf/source/file_io.h"
#include "suites/scenes/gltf/source/image_codec.h"
#include "suites/scenes/gltf/source/source.h"
#include "suites/scenes/gltf/write/export.h"
#include "techniques/plan/error.h"
#include "techniques/scene/box.h"

namespace sb {
namespace {

void appendWord(std::vector<uint8_t>& out, size_t value) {
  const uint32_t word = uint32_t(value);
  const auto* bytes = reinterpret_cast<const uint8_t*>(&word);
  out.insert(out.end(), bytes, bytes + 4);
}

void pad(std::vector<uint8_t>& bytes, uint8_t with) {
  while (bytes.size() % 4 != 0) bytes.push_back(with);
}

bool mirrors(const Instance& instance) {
  return glm::determinant(glm::dmat3(instance.toWorld)) < 0;
}

}  // namespace

nlohmann::json matrixJson(const glm::dmat4& m) {
  nlohmann::json array = nlohmann::json::array();
  for (int i = 0; i < 16; ++i) array.push_back(m[i / 4][i % 4]);
  return array;
}

size_t GltfWriter::addView(const void* data, size_t bytes) {
  pad(m_bytes, 0);
  m_gltf["bufferViews"].push_back(
      {{"buffer", 0}, {"byteOffset", m_bytes.size()}, {"byteLength", bytes}});
  const auto* begin = static_cast<const uint8_t*>(data);
  m_bytes.insert(m_bytes.end(), begin, begin + bytes);
  return m_gltf["bufferViews"].size() - 1;
}

template <typename V>
size_t GltfWriter::addAccessor(const std::vector<V>& values) {
  m_gltf["accessors"].push_back({{"bufferView", addView(values.data(), values.size() * sizeof(V))},
                                 {"componentType", 5126},
                                 {"count", values.size()},
                                 {"type", "VEC" + std::to_string(V::length())}});
  return m_gltf["accessors"].size() - 1;
}

size_t GltfWriter::addScalars(const void* data, size_t count, int componentType) {
  m_gltf["accessors"].push_back({{"bufferView", addView(data, count * 4)},
                                 {"componentType", componentType},
                                 {"count", count},
                                 {"type", "SCALAR"}});
  return m_gltf["accessors"].size() - 1;
}

size_t GltfWriter::addIndices(const std::vector<uint32_t>& indices) {
  return addScalars(indices.data(), indices.size(), 5125);
}

void GltfWriter::addImages() {
  for (const Image& image : m_scene.images) {
    if (image.rgba.empty()) {
      // Of an image that could not be read only its place is left.
      m_gltf["images"].push_back({{"uri", "data:,"}, {"name", image.name}});
      continue;
    }
    const std::vector<uint8_t> png = encodePng(image);
    m_gltf["images"].push_back({{"bufferView", addView(png.data(), png.size())},
                                {"mimeType", "image/png"},
                                {"name", image.name}});
  }
}

size_t GltfWriter::meshFor(const Instance& instance) {
  const Material& material = m_scene.materials.at(m_scene.meshes.at(instance.mesh).material);
  // Thickness is stated in mesh units and grows with the node's scale when read.
  double scale = 1;
  if (material.thickness > 0)
    scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(instance.toWorld))));
  if (std::abs(scale - 1) < 1e-6) scale = 1;
  return addMesh(instance.mesh, mirrors(instance), scale);
}

size_t GltfWriter::addMesh(uint32_t index, bool mirrored, double thicknessScale) {
  const auto [found, added] = m_meshes.try_emplace({index, mirrored, thicknessScale}, 0);
  if (!added) return found->second;
  // Reading turns the winding of mirrored instances; it must not do so twice.
  const Mesh turned = mirrored ? mirroredMesh(m_scene.meshes[index]) : Mesh();
  const Mesh& mesh = mirrored ? turned : m_scene.meshes[index];
  json attributes = {{"POSITION", addAccessor(mesh.positions)}};
  glm::vec3 low = mesh.positions.at(0), high = low;
  for (const glm::vec3& p : mesh.positions) low = glm::min(low, p), high = glm::max(high, p);
  m_gltf["accessors"].back()["min"] = vectorJson(low);
  m_gltf["accessors"].back()["max"] = vectorJson(high);
  const auto add = [&](const char* name, const auto& values) {
    if (!values.empty()) attributes[name] = addAccessor(values);
  };
  add("NORMAL", mesh.normals);
  add("TANGENT", mesh.tangents);
  add("TEXCOORD_0", mesh.uv0);
  add("TEXCOORD_1", mesh.uv1);
  add("COLOR_0", mesh.colors);
  const json primitive = {{"attributes", attributes},
                          {"indices", addIndices(mesh.indices)},
                          {"material", materialFor(mesh.material, thicknessScale)}};
  m_gltf["meshes"].push_back({{"name", mesh.name}, {"primitives", json::array({primitive})}});
  return found->second = m_gltf["meshes"].size() - 1;
}

size_t GltfWriter::addNode(json node) {
  m_gltf["nodes"].push_back(std::move(node));
  m_gltf["scenes"][0]["nodes"].push_back(m_gltf["nodes"].size() - 1);
  return m_gltf["nodes"].size() - 1;
}

void GltfWriter::addInstances() {
  // Meshes in their order first, so that they come back in it.
  std::vector<std::vector<const Instance*>> users(m_scene.meshes.size());
  for (const Instance& instance : m_scene.instances) users.at(instance.mesh).push_back(&instance);
  for (const auto& instances : users)
    for (const Instance* instance : instances) meshFor(*instance);
  for (const Instance& instance : m_scene.instances) {
    json node = {{"name", instance.name}, {"mesh", meshFor(instance)}};
    if (instance.toWorld != glm::dmat4(1)) node["matrix"] = matrixJson(instance.toWorld);
    addNode(std::move(node));
  }
}

void GltfWriter::addMedia() {
  for (const Medium& medium : m_scene.media) {
    constexpr const char* kKinds[] = {"homogeneous", "smoke", "grid"};
    json ours = {{"kind", kKinds[size_t(medium.kind)]},
                 {"extinction", vectorJson(medium.extinction)},
                 {"albedo", vectorJson(medium.albedo)},
                 {"anisotropy", medium.anisotropy},
                 {"seed", medium.seed},
                 {"time", medium.time}};
    if (medium.kind == MediumKind::Grid) {
      ours["size"] = vectorJson(medium.size);
      ours["density"] = addScalars(medium.density.data(), medium.density.size(), 5126);
    }
    addNode({{"name", medium.name},
             {"matrix", matrixJson(medium.boxToWorld)},
             {"extras", {{"shadowbench", {{"medium", ours}}}}}});
  }
}

std::vector<uint8_t> GltfWriter::write() {
  m_gltf["asset"] = {{"version", "2.0"}, {"generator", "ShadowBench"}};
  m_gltf["scene"] = 0;
  m_gltf["scenes"][0] = {{"nodes", json::array()},
                         {"extras",
                          {{"shadowbench",
                            {{"ambient", vectorJson(m_scene.ambient)},
                             {"background", vectorJson(m_scene.background)}}}}}};
  if (m_scene.sky != glm::vec3(0))
    m_gltf["scenes"][0]["extras"]["shadowbench"]["sky"] = vectorJson(m_scene.sky);
  addImages();
  for (uint32_t i = 0; i < m_scene.materials.size(); ++i) {
    // The first scale that a material is used at keeps its place in the list.
    double scale = 1;
    if (m_scene.materials[i].thickness > 0)
      for (auto at = m_scene.instances.rbegin(); at != m_scene.instances.rend(); ++at)
        if (m_scene.meshes.at(at->mesh).material == i)
          scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(at->toWorld))));
    materialFor(i, std::abs(scale - 1) < 1e-6 ? 1 : scale);
  }
  addInstances();
  addMedia();
  addLights();
  addCameras();
  if (!m_extensions.empty()) m_gltf["extensionsUsed"] = m_extensions;
  pad(m_bytes, 0);
  if (!m_bytes.empty()) m_gltf["buffers"] = json::array({{{"byteLength", m_bytes.size()}}});

  const std::string text = m_gltf.dump(-1, ' ', true, json::error_handler_t::replace);
  std::vector<uint8_t> jsonBytes(text.begin(), text.end());
  pad(jsonBytes, ' ');
  if (jsonBytes.size() > kMaxJsonBytes)
    throw InputError("export", "the scene's JSON would have " + std::to_string(jsonBytes.size()) +
                                   " bytes, at most " + std::to_string(kMaxJsonBytes) +
                                   " are read again; nothing was written");
  std::vector<uint8_t> file = {'g', 'l', 'T', 'F'};
  const size_t binary = m_bytes.empty() ? 0 : 8 + m_bytes.size();
  appendWord(file, 2);
  appendWord(file, 20 + jsonBytes.size() + binary);
  appendWord(file, jsonBytes.size());
  file.insert(file.end(), {'J', 'S', 'O', 'N'});
  file.insert(file.end(), jsonBytes.begin(), jsonBytes.end());
  if (binary == 0) return file;
  appendWord(file, m_bytes.size());
  file.insert(file.end(), {'B', 'I', 'N', 0});
  file.insert(file.end(), m_bytes.begin(), m_bytes.end());
  return file;
}

void exportGlb(const Scene& scene, const std::filesystem::path& path) {
  const std::vector<uint8_t> bytes = GltfWriter(scene).write();
  // What is written must load again.
  if (bytes.size() > kMaxFileBytes)
    throw InputError(path.string(), "would have " + std::to_string(bytes.size()) +
                                        " bytes, at most " + std::to_string(kMaxFileBytes) +
                                        " are read again; nothing was written");
  writeWholeFile(path, bytes);
}

}  // namespace sb
