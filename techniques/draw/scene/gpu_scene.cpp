#include "techniques/draw/scene/gpu_scene.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <tuple>

#include "shaders/common/shared_slots.h"
#include "techniques/scene/material_data.h"

namespace sb {
namespace {

struct Attributes {
  glm::vec3 normal;
  glm::vec4 tangent;
  glm::vec2 uv0, uv1;
  glm::vec4 color;
};
static_assert(sizeof(Attributes) == 60);

template <class T>
rhi::Buffer makeBuffer(rhi::Device& device, const char* label, const std::vector<T>& data,
                       rhi::BufferUse use) {
  rhi::Buffer buffer = device.createBuffer({.label = label,
                                            .size = std::max<uint64_t>(16, data.size() * sizeof(T)),
                                            .use = use | rhi::BufferUse::CopyTarget});
  device.upload(buffer, 0, std::as_bytes(std::span(data)));
  return buffer;
}

template <class T>
T at(const std::vector<T>& values, size_t i, T fallback) {
  return values.empty() ? fallback : values[i];
}

rhi::AddressMode addressMode(Wrap wrap) {
  switch (wrap) {
    case Wrap::MirroredRepeat:
      return rhi::AddressMode::MirroredRepeat;
    case Wrap::ClampToEdge:
      return rhi::AddressMode::ClampToEdge;
    default:
      return rhi::AddressMode::Repeat;
  }
}

}  // namespace

GpuScene::GpuScene(rhi::Device& device, const Scene& scene) : m_scene(scene) {
  uploadMeshes(device);
  uploadMaterials(device);
  device.waitIdle();
}

void GpuScene::analyseSteps(const std::vector<ConcaveSides>& sides) {
  const Moving moving(m_scene);
  const auto each = [&](bool moves, const auto& analyse) {
    const size_t steps = moves ? m_scene.path.size() : 1;
    for (uint32_t k = 0; k < steps; ++k) analyse(PlacedScene(m_scene, k));
  };
  each(!moving.instances.empty(),
       [&](const PlacedScene& placed) { m_coplanar.emplace_back(placed); });
  each(!moving.instances.empty() || moving.lights, [&](const PlacedScene& placed) {
    std::vector<bool>& rises = m_rises.emplace_back();
    for (uint32_t i = 0; i < m_scene.instances.size(); ++i)
      rises.push_back(risesInLight(placed, i, sides[m_scene.instances[i].mesh]));
  });
}

bool GpuScene::everRises(uint32_t instance) const {
  return std::ranges::any_of(m_rises, [&](const auto& rises) { return rises[instance]; });
}

bool GpuScene::everCoplanar() const {
  return !std::ranges::all_of(m_coplanar, &CoplanarSurfaces::empty);
}

void GpuScene::uploadMeshes(rhi::Device& device) {
  std::vector<glm::vec3> positions;
  std::vector<Attributes> attributes;
  std::vector<uint32_t> indices;
  std::vector<gpu::TriangleData> triangles;
  std::vector<ConcaveSides> sides;
  for (const Mesh& mesh : m_scene.meshes) {
    m_meshes.push_back({.firstIndex = uint32_t(indices.size()),
                        .indexCount = uint32_t(mesh.indices.size()),
                        .vertexOffset = int32_t(positions.size()),
                        .firstTriangle = uint32_t(triangles.size())});
    const ConcaveSides& concave = sides.emplace_back(concaveSides(mesh));
    positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
    const size_t first = indices.size();
    indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
    for (size_t i = 0; i < mesh.positions.size(); ++i)
      attributes.push_back({at(mesh.normals, i, glm::vec3(0, 0, 1)),
                            at(mesh.tangents, i, glm::vec4(1, 0, 0, 1)),
                            at(mesh.uv0, i, glm::vec2(0)), at(mesh.uv1, i, glm::vec2(0)),
                            at(mesh.colors, i, glm::vec4(1))});
    for (uint32_t t = 0; t < mesh.triangleCount(); ++t) {
      const glm::dvec3 a = mesh.positions[mesh.indices[3 * t]];
      const glm::dvec3 b = mesh.positions[mesh.indices[3 * t + 1]];
      const glm::dvec3 c = mesh.positions[mesh.indices[3 * t + 2]];
      const glm::dvec3 n = glm::cross(b - a, c - a);
      const double length = glm::length(n);
      // The length says which sides are concave (shaders/common/shared_types.h).
      const float scale = float(1u << concave.ofTriangle[t]);
      const glm::vec3 normal = length > 0 ? scale * glm::vec3(n / length) : glm::vec3(0);
      // Three points on a line may cover a texel once they are rounded, at any depth (spec 17, G5):
      // three times one point covers none.
      if (!(length > 0))
        for (uint32_t c = 1; c < 3; ++c) indices[first + 3 * t + c] = indices[first + 3 * t];
      triangles.push_back({glm::vec4(normal, glm::uintBitsToFloat(mesh.triangleKeys[t]))});
    }
  }
  analyseSteps(sides);
  using U = rhi::BufferUse;
  m_positions = makeBuffer(device, "scene positions", positions, U::Vertex | U::Storage);
  m_attributes = makeBuffer(device, "scene attributes", attributes, U::Vertex);
  m_indices = makeBuffer(device, "scene indices", indices, U::Index | U::Storage);
  m_triangles = makeBuffer(device, "scene triangles", triangles, U::Storage);
}

void GpuScene::uploadMaterials(rhi::Device& device) {
  const uint64_t align = device.info().limits.uniformAlignment;
  m_materialStride = (sizeof(gpu::MaterialData) + align - 1) / align * align;
  std::vector<std::byte> data(std::max<size_t>(1, m_scene.materials.size()) * m_materialStride);
  for (size_t i = 0; i < m_scene.materials.size(); ++i) {
    const gpu::MaterialData material = materialData(m_scene.materials[i]);
    std::memcpy(data.data() + i * m_materialStride, &material, sizeof material);
  }
  m_materials = makeBuffer(device, "scene materials", data, rhi::BufferUse::Uniform);

  auto addTexture = [&](const std::string& label, const Image& image, bool srgb) {
    rhi::Texture texture =
        device.createTexture({.label = label,
                              .format = srgb ? rhi::Format::RGBA8Srgb : rhi::Format::RGBA8Unorm,
                              .width = image.width,
                              .height = image.height,
                              .use = rhi::TextureUse::Sampled | rhi::TextureUse::CopyTarget});
    device.upload(texture, {}, std::as_bytes(std::span(image.rgba)));
    m_textures.push_back(std::move(texture));
    return m_textures.back().id();
  };
  // Slots without a texture are bound to one white texel: every shader variant finds its bindings.
  const rhi::TextureId white =
      addTexture("scene white",
                 {.name = "white", .width = 1, .height = 1, .rgba = {255, 255, 255, 255}}, false);
  std::map<std::pair<uint32_t, bool>, rhi::TextureId> textures;
  std::map<std::tuple<Wrap, Wrap, bool>, rhi::SamplerId> samplers;
  auto sampler = [&](const TextureSlot& slot) {
    auto [it, isNew] = samplers.try_emplace({slot.wrapU, slot.wrapV, slot.nearest});
    if (isNew) {
      m_samplers.push_back(
          device.createSampler({.label = "scene sampler",
                                .filter = slot.nearest ? rhi::Filter::Nearest : rhi::Filter::Linear,
                                .addressU = addressMode(slot.wrapU),
                                .addressV = addressMode(slot.wrapV)}));
      it->second = m_samplers.back().id();
    }
    return it->second;
  };
  for (const Material& m : m_scene.materials) {
    auto& bindings = m_textureBindings.emplace_back();
    for (uint32_t i = 0; i < MATERIAL_TEXTURES; ++i) {
      const TextureSlot& slot = textureSlot(m, i);
      rhi::TextureId texture = white;
      if (slot.present()) {
        m_textured = true;
        auto [it, isNew] = textures.try_emplace({slot.image, slot.srgb});
        if (isNew) it->second = addTexture("scene textures", m_scene.images[slot.image], slot.srgb);
        texture = it->second;
      }
      bindings.push_back(rhi::textureAt(TEXTURE_MATERIAL + i, texture, sampler(slot)));
    }
  }
}

std::vector<rhi::VertexBufferLayout> GpuScene::vertexLayout(bool withAttributes) {
  std::vector<rhi::VertexBufferLayout> layout = {{.stride = sizeof(glm::vec3)}};
  if (withAttributes) layout.push_back({.stride = sizeof(Attributes)});
  layout.push_back({.stride = sizeof(gpu::InstanceData), .perInstance = true});
  return layout;
}

std::vector<rhi::VertexAttribute> GpuScene::vertexAttributes(bool withAttributes) {
  using F = rhi::VertexFormat;
  std::vector<rhi::VertexAttribute> list = {{.location = 0, .buffer = 0, .format = F::Float3}};
  uint32_t buffer = 1;
  auto add = [&](uint32_t location, F format, size_t offset) {
    list.push_back(
        {.location = location, .buffer = buffer, .format = format, .offset = uint32_t(offset)});
  };
  if (withAttributes) {
    add(1, F::Float3, offsetof(Attributes, normal));
    add(2, F::Float4, offsetof(Attributes, tangent));
    add(3, F::Float2, offsetof(Attributes, uv0));
    add(4, F::Float2, offsetof(Attributes, uv1));
    add(5, F::Float4, offsetof(Attributes, color));
    ++buffer;
  }
  add(6, F::Float4, offsetof(gpu::InstanceData, toRelative0));
  add(7, F::Float4, offsetof(gpu::InstanceData, toRelative1));
  add(8, F::Float4, offsetof(gpu::InstanceData, toRelative2));
  add(9, F::Uint4, offsetof(gpu::InstanceData, ids));
  add(10, F::Uint4, offsetof(gpu::InstanceData, order));
  if (withAttributes) {
    add(11, F::Float4, offsetof(gpu::InstanceData, normal0));
    add(12, F::Float4, offsetof(gpu::InstanceData, normal1));
    add(13, F::Float4, offsetof(gpu::InstanceData, normal2));
  }
  return list;
}

rhi::Binding GpuScene::material(uint32_t index) const {
  return rhi::uniformAt(UNIFORM_MATERIAL, m_materials, index * m_materialStride,
                        sizeof(gpu::MaterialData));
}
rhi::Binding GpuScene::triangles() const { return rhi::storageAt(STORAGE_TRIANGLES, m_triangles); }

}  // namespace sb
