#include "techniques/volumes/light_wedges.h"

#include <algorithm>
#include <cstring>

#include "shaders/common/shared_slots.h"
#include "techniques/scene/box.h"

namespace sb {
namespace {

/// As shaders place vertices (common/transform.glsl): to the last bit.
glm::vec3 toRelative(const gpu::VolumeData& v, const glm::vec3& p) {
  const auto along = [&](const glm::vec4& row) {
    return row.x * p.x + row.y * p.y + row.z * p.z + row.w;
  };
  return {along(v.row0), along(v.row1), along(v.row2)};
}

uint64_t blockStride(const rhi::Device& device) {
  const uint64_t to = device.info().limits.uniformAlignment;
  return (sizeof(gpu::WedgeLightData) + to - 1) / to * to;
}

/// Of a light among those that touch the view.
uint32_t numberInView(const SceneView& view, uint32_t light) {
  uint32_t number = 0;
  for (const LightEffects& effects : view.effects().lights) {
    if (effects.light == light) break;
    number += effects.touchesView;
  }
  return number;
}

/// Many times as far from the eye as anything: there hulls end before parallel eyes, whose rays
/// none of the ways of light are perpendicular to.
double reachOf(const SceneView& view) {
  Box all;
  for (uint32_t i = 0; i < view.scene().instances.size(); ++i)
    all.add(instanceBox(view.placed(), i, view.camera().eye));
  return 32 * (glm::length(all.center()) + all.radius());
}

}  // namespace

void LightWedges::reserve(std::span<const LightVolumes* const> lights) {
  uint64_t wedges = 0, casters = 0;
  for (const LightVolumes* light : lights)
    for (const CasterVolume& volume : light->casters) {
      // Another eye may have all triangles cast.
      wedges += m_context.view.isFree() ? volume.data.counts.x : volume.items[VOLUME_SIDES];
      ++casters;
    }
  m_mostWedges = std::max(m_mostWedges, wedges);
  m_mostCasters = std::max(m_mostCasters, casters);
  m_mostLights = std::max<uint64_t>(m_mostLights, lights.size());
}

void LightWedges::createBuffers() {
  using U = rhi::BufferUse;
  const auto make = [&](const char* label, uint64_t size, U use) {
    return m_context.device.createBuffer(
        {.label = label, .size = std::max<uint64_t>(16, size), .use = use | U::CopyTarget});
  };
  m_wedgeBuffer = make("penumbra wedges", m_mostWedges * sizeof(gpu::WedgeData), U::Storage);
  m_casterBuffer = make("wedge casters", m_mostCasters * sizeof(gpu::WedgeCaster), U::Storage);
  m_lightBlocks = make("wedge lights", m_mostLights * blockStride(m_context.device), U::Uniform);
}

void LightWedges::find(const ShadowVolumes& volumes, std::span<const LightVolumes* const> lights,
                       const Write& write) {
  const SceneView& view = m_context.view;
  m_wedges.clear();
  m_casters.clear();
  m_lights.clear();
  m_everywhere = 0;
  m_reach = view.placed().camera().orthographic ? reachOf(view) : 0;
  const uint64_t stride = blockStride(m_context.device);
  std::vector<std::byte> blocks(lights.size() * stride);
  for (const LightVolumes* light : lights) {
    const WedgeLight wedges = wedgeLight(view.placed().light(light->light), view.camera().eye);
    LightRange& range = m_lights.emplace_back();
    range.wedges.first = uint32_t(m_wedges.size());
    range.casters = {uint32_t(m_casters.size()), uint32_t(light->casters.size())};
    for (const CasterVolume& volume : light->casters) addCaster(volumes, volume, wedges);
    range.wedges.count = uint32_t(m_wedges.size()) - range.wedges.first;
    const gpu::WedgeLightData block{
        {numberInView(view, light->light), range.casters.first, range.casters.count, 0}};
    std::memcpy(blocks.data() + (m_lights.size() - 1) * stride, &block, sizeof block);
  }
  bind();
  if (lights.empty()) return;
  write(m_lightBlocks, blocks);
  write(m_casterBuffer, std::as_bytes(std::span(m_casters)));
  if (!m_wedges.empty()) write(m_wedgeBuffer, std::as_bytes(std::span(m_wedges)));
}

void LightWedges::addCaster(const ShadowVolumes& volumes, const CasterVolume& volume,
                            const WedgeLight& light) {
  const SceneView& view = m_context.view;
  const Mesh& mesh = view.scene().meshes[volume.mesh];
  const GpuScene::MeshRange& range = view.gpu().mesh(volume.mesh);
  const Box box = instanceBox(view.placed(), volume.instance, view.camera().eye);
  gpu::WedgeCaster caster{.volume = volume.data,
                          .sphere = glm::vec4(glm::vec3(box.center()), 1.0001 * box.radius()),
                          .wedges = {uint32_t(m_wedges.size()), 0, 0, 0}};
  caster.volume.first.y = range.firstIndex;
  caster.volume.first.z = 3 * uint32_t(range.vertexOffset);
  const std::span<const uint32_t> sides = volumes.items(volume, VOLUME_SIDES);
  for (size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end] == sides[i]) ++end;
    const glm::uvec4 ends = volumes.edges(volume.mesh).mesh.edges[sides[i] >> 1].ends;
    const glm::vec3 a = toRelative(volume.data, mesh.positions[ends.x]);
    const glm::vec3 b = toRelative(volume.data, mesh.positions[ends.y]);
    const bool back = (sides[i] & 1) == 1;
    addWedge(light, back ? b : a, back ? a : b, float(end - i));
  }
  caster.wedges.y = uint32_t(m_wedges.size()) - caster.wedges.x;
  m_casters.push_back(caster);
}

void LightWedges::addWedge(const WedgeLight& light, const glm::vec3& a, const glm::vec3& b,
                           float times) {
  const Wedge made = wedge(light, a, b);
  gpu::WedgeData data{
      .start = glm::vec4(a, times), .end = glm::vec4(b, made.holds ? 0 : 1), .hull = {}};
  for (size_t i = 0; made.holds && i < WEDGE_CORNERS; ++i) {
    data.hull[i] = made.hull[i];
    if (i < 2 || m_reach == 0) continue;
    // Parallel eyes see no infinity.
    const glm::dvec3 way = glm::normalize(glm::dvec3(made.hull[i]));
    data.hull[i] = glm::vec4(glm::dvec3(made.hull[i < 4 ? 0 : 1]) + m_reach * way, 1);
  }
  m_everywhere += !made.holds;
  m_wedges.push_back(data);
}

void LightWedges::bind() {
  const SceneView& view = m_context.view;
  const uint64_t stride = blockStride(m_context.device);
  for (size_t i = 0; i < m_lights.size(); ++i) {
    std::vector<rhi::Binding>& bindings = m_lights[i].bindings = view.bindings();
    bindings.push_back(
        rhi::uniformAt(UNIFORM_TECHNIQUE, m_lightBlocks, i * stride, sizeof(gpu::WedgeLightData)));
    bindings.push_back(rhi::storageAt(STORAGE_TECHNIQUE, m_wedgeBuffer));
    bindings.push_back(rhi::storageAt(STORAGE_TECHNIQUE + 1, m_casterBuffer));
    bindings.push_back(rhi::storageAt(STORAGE_TECHNIQUE + 2, view.gpu().indices()));
    bindings.push_back(rhi::storageAt(STORAGE_TECHNIQUE + 3, view.gpu().positions()));
  }
}

}  // namespace sb
