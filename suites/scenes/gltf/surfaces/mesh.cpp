// Mesh primitives as indexed triangle lists with every attribute that shading needs.
#include <cmath>
#include <optional>

#include "suites/scenes/edit/mesh_tools.h"
#include "suites/scenes/gltf/surfaces/deform.h"

namespace sb {
namespace {

using tinygltf::Primitive;

bool quantized(const GltfContext& context) {
  const auto& used = context.model.extensionsUsed;
  const auto& required = context.model.extensionsRequired;
  return std::ranges::find(used, "KHR_mesh_quantization") != used.end() ||
         std::ranges::find(required, "KHR_mesh_quantization") != required.end();
}

struct Attribute {
  int accessor = -1;  ///< -1: the primitive has none
  std::string field;
};

Attribute findAttribute(const Primitive& primitive, const std::string& field, const char* name) {
  const auto found = primitive.attributes.find(name);
  if (found == primitive.attributes.end()) return {};
  return {found->second, field + ".attributes." + name};
}

// Floats of an attribute, checked against what glTF allows for it.
std::vector<float> readAttribute(const GltfContext& context, const Attribute& a, int components,
                                 size_t count, bool normalizedIntegers) {
  const tinygltf::Accessor& accessor = context.model.accessors[size_t(a.accessor)];
  const int found = componentCount(context, a.field, a.accessor);
  if (found != components)
    context.fail(a.field, "has " + std::to_string(found) + " components, expected " +
                              std::to_string(components));
  const bool isFloat = accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
  if (!isFloat && !quantized(context) && !(normalizedIntegers && accessor.normalized))
    context.fail(a.field, "has componentType " + std::to_string(accessor.componentType) +
                              (normalizedIntegers ? ", expected floats or normalized integers"
                                                  : ", expected 5126 (float)"));
  if (accessor.count != count)
    context.fail(a.field, "has " + std::to_string(accessor.count) + " elements, POSITION has " +
                              std::to_string(count));
  return readFloats(context, a.field, a.accessor, components);
}

template <typename V>
std::vector<V> asVectors(const std::vector<float>& floats) {
  constexpr size_t n = size_t(V::length());
  std::vector<V> vectors(floats.size() / n);
  for (size_t i = 0; i < vectors.size(); ++i)
    for (size_t c = 0; c < n; ++c) vectors[i][int(c)] = floats[i * n + c];
  return vectors;
}

// Triangle list of strips and fans, corners in glTF's order (section 3.7.2.1).
std::vector<uint32_t> toTriangleList(int mode, const std::vector<uint32_t>& v) {
  std::vector<uint32_t> list;
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    list.assign(v.begin(), v.end() - std::ptrdiff_t(v.size() % 3));
    return list;
  }
  for (size_t i = 0; i + 2 < v.size(); ++i) {
    if (mode == TINYGLTF_MODE_TRIANGLE_STRIP)
      list.insert(list.end(), {v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]});
    else
      list.insert(list.end(), {v[i + 1], v[i + 2], v[0]});
  }
  return list;
}

void readPositions(const GltfContext& context, const Attribute& position, Mesh& mesh) {
  const size_t count = context.model.accessors[size_t(position.accessor)].count;
  mesh.positions = asVectors<glm::vec3>(readAttribute(context, position, 3, count, false));
}

void readTriangles(const GltfContext& context, const Primitive& primitive, const std::string& field,
                   int mode, Mesh& mesh) {
  std::vector<uint32_t> corners;
  if (primitive.indices >= 0) {
    corners = readIndices(context, field + ".indices", primitive.indices);
  } else {
    corners.resize(mesh.positions.size());
    for (size_t i = 0; i < corners.size(); ++i) corners[i] = uint32_t(i);
  }
  for (size_t i = 0; i < corners.size(); ++i)
    if (corners[i] >= mesh.positions.size())
      context.fail(field + ".indices", "element " + std::to_string(i) + " is " +
                                           std::to_string(corners[i]) + ", but there are " +
                                           std::to_string(mesh.positions.size()) + " vertices");
  mesh.indices = toTriangleList(mode, corners);
  numberTriangles(mesh);
}

void readColours(const GltfContext& context, const Attribute& colour, Mesh& mesh) {
  const int components = componentCount(context, colour.field, colour.accessor);
  if (components != 3 && components != 4)
    context.fail(colour.field,
                 "has " + std::to_string(components) + " components, expected 3 or 4");
  const std::vector<float> floats =
      readAttribute(context, colour, components, mesh.positions.size(), true);
  mesh.colors.assign(mesh.positions.size(), glm::vec4(1));
  for (size_t i = 0; i < mesh.colors.size(); ++i)
    for (int c = 0; c < components; ++c)
      mesh.colors[i][c] = glm::clamp(floats[i * size_t(components) + size_t(c)], 0.0f, 1.0f);
}

void readFrames(const GltfContext& context, const Attribute& normal, const Attribute& tangent,
                Mesh& mesh) {
  if (normal.accessor < 0) return;
  mesh.normals =
      asVectors<glm::vec3>(readAttribute(context, normal, 3, mesh.positions.size(), false));
  if (context.scene.materials[mesh.material].normalTexture.present() && tangent.accessor >= 0)
    mesh.tangents =
        asVectors<glm::vec4>(readAttribute(context, tangent, 4, mesh.positions.size(), false));
}

void finish(GltfContext& context, const std::string& field, Mesh& mesh) {
  const Material& material = context.scene.materials[mesh.material];
  const bool mapped = material.normalTexture.present();
  context.degenerate += dropDegenerate(mesh);
  if (mesh.normals.empty())
    makeFlatNormals(mesh);
  else
    context.repairedNormals += repairNormals(mesh);
  for (glm::vec4& t : mesh.tangents) {
    const float length = glm::length(glm::vec3(t));
    // One bad tangent would become NaN in the shader: then all are made anew.
    if (!(length > 1e-6f && std::isfinite(length) && std::abs(t.w) == 1)) {
      context.warn(field + ": tangents are not unit vectors with w = 1 or -1; they were generated");
      mesh.tangents.clear();
      break;
    }
    if (std::abs(length - 1) > 1e-6f) t = glm::vec4(glm::vec3(t) / length, t.w);
  }
  if (mapped && mesh.tangents.empty()) makeTangents(mesh, material.normalTexture.uvSet);
  computeBounds(mesh);
}

void checkTextureCoordinates(GltfContext& context, const std::string& field, const Mesh& mesh) {
  const Material& m = context.scene.materials[mesh.material];
  for (const TextureSlot* slot :
       {&m.baseColorTexture, &m.metallicRoughnessTexture, &m.normalTexture, &m.occlusionTexture,
        &m.emissiveTexture, &m.transmissionTexture, &m.thicknessTexture})
    if (slot->present() && (slot->uvSet == 0 ? mesh.uv0 : mesh.uv1).empty())
      context.warn(field + " has no TEXCOORD_" + std::to_string(slot->uvSet) +
                   ", which its material's textures use: they are sampled at (0, 0)");
}

// The material of primitives without one: glTF's default, at the end of the list.
uint32_t defaultMaterial(GltfContext& context) {
  std::vector<Material>& materials = context.scene.materials;
  if (materials.size() == context.model.materials.size()) {
    materials.emplace_back();
    materials.back().name = "default";
  }
  return uint32_t(materials.size() - 1);
}

// Counts what a primitive will take before any of it is made.
void takeMemory(GltfContext& context, const Primitive& primitive, const std::string& field,
                const Attribute& position, int mode, bool flat) {
  const size_t vertices = context.model.accessors[size_t(position.accessor)].count;
  const size_t corners =
      primitive.indices >= 0 ? context.model.accessors[size_t(primitive.indices)].count : vertices;
  const size_t triangles = mode == TINYGLTF_MODE_TRIANGLES ? corners / 3 : corners;
  context.vertices += vertices;
  context.triangles += triangles;
  if (context.vertices > kMaxVertices || context.triangles > kMaxTriangles)
    context.fail(
        field, "takes the file beyond " + std::to_string(kMaxVertices) + " vertices or triangles");
  // Attributes and what a device keeps of them; vertices of their own for every corner without
  // normals.
  context.source.take(field, vertices, 72);
  context.source.take(field, triangles, flat ? 16 + 3 * 72 : 16);
}

// One primitive as a mesh; empty if it draws no triangles. Bent by `deform`.
std::optional<Mesh> readPrimitive(GltfContext& context, size_t m, size_t p, const Deform& deform) {
  const tinygltf::Mesh& source = context.model.meshes[m];
  const Primitive& primitive = source.primitives[p];
  const std::string field = fieldAt(fieldAt("meshes", m) + ".primitives", p);
  const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
  if (mode < TINYGLTF_MODE_TRIANGLES) {
    constexpr const char* kModes[] = {"points", "lines", "a line loop", "a line strip"};
    context.warn(field + " is drawn as " + kModes[mode] + ", which is left out");
    return std::nullopt;
  }
  const Attribute position = findAttribute(primitive, field, "POSITION");
  if (position.accessor < 0) {
    context.warn(field + " has no POSITION and is left out");
    return std::nullopt;
  }
  Mesh mesh;
  mesh.name = source.name.empty() ? "mesh" + std::to_string(m) : source.name;
  if (source.primitives.size() > 1) mesh.name += "." + std::to_string(p);
  mesh.material = primitive.material >= 0 ? uint32_t(primitive.material) : defaultMaterial(context);
  const Attribute normal = findAttribute(primitive, field, "NORMAL");
  takeMemory(context, primitive, field, position, mode, normal.accessor < 0);
  readPositions(context, position, mesh);
  readTriangles(context, primitive, field, mode, mesh);
  for (const auto& [name, uvs] : {std::pair("TEXCOORD_0", &mesh.uv0), {"TEXCOORD_1", &mesh.uv1}})
    if (const Attribute uv = findAttribute(primitive, field, name); uv.accessor >= 0)
      *uvs = asVectors<glm::vec2>(readAttribute(context, uv, 2, mesh.positions.size(), true));
  if (const Attribute c = findAttribute(primitive, field, "COLOR_0"); c.accessor >= 0)
    readColours(context, c, mesh);
  readFrames(context, normal, findAttribute(primitive, field, "TANGENT"), mesh);
  applyMorph(context, m, p, deform.weights, mesh);
  applySkin(context, m, p, deform, mesh);
  finish(context, field, mesh);
  checkTextureCoordinates(context, field, mesh);
  if (!mesh.indices.empty()) return mesh;
  context.warn(field + " has no triangles and is left out");
  return std::nullopt;
}

}  // namespace

std::vector<uint32_t> readBentMeshes(GltfContext& context, size_t mesh, const Deform& deform) {
  std::vector<uint32_t> made;
  for (size_t p = 0; p < context.model.meshes[mesh].primitives.size(); ++p) {
    std::optional<Mesh> part = readPrimitive(context, mesh, p, deform);
    if (!part) continue;
    part->key = uint32_t(context.scene.meshes.size());
    made.push_back(part->key);
    context.scene.meshes.push_back(std::move(*part));
  }
  return made;
}

void readMeshes(GltfContext& context) {
  for (size_t m = 0; m < context.model.meshes.size(); ++m)
    context.meshes.push_back(
        readBentMeshes(context, m, {.weights = meshWeights(context, m), .palette = {}}));
}

}  // namespace sb
