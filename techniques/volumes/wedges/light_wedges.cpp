#include "techniques/volumes/wedges/light_wedges.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "shaders/common/shared_slots.h"
#include "techniques/draw/scene/storage_window.h"
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

/// As many elements as an aligned start of a binding may be apart.
template <class T>
uint64_t startStride(const rhi::Device& device) {
  const uint64_t to = std::max<uint64_t>(1, device.info().limits.storageAlignment);
  return to / std::gcd(to, uint64_t(sizeof(T)));
}

template <class T>
uint32_t nextStart(const rhi::Device& device, std::vector<T>& all) {
  const uint64_t stride = startStride<T>(device);
  all.resize((all.size() + stride - 1) / stride * stride);
  return uint32_t(all.size());
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
double hullReach(const SceneView& view) {
  const Box all = instancesBox(view.placed(), view.camera().eye);
  return 32 * (glm::length(all.center()) + all.radius());
}

}  // namespace

void LightWedges::reserve(std::span<const LightVolumes* const> lights) {
  const rhi::Device& device = m_context.device;
  uint64_t wedges = lights.size() * startStride<gpu::WedgeData>(device);
  uint64_t casters = lights.size() * startStride<gpu::WedgeCaster>(device);
  uint64_t triangles = lights.size() * startStride<gpu::WedgeTriangle>(device);
  for (const LightVolumes* light : lights)
    for (const CasterVolume& volume : light->casters) {
      // Another eye may have all edges and triangles cast, and both sides of an edge in loops of
      // their own.
      const bool free = m_context.view.isFree();
      wedges += free ? 2 * uint64_t(volume.data.counts.x) : volume.items[VOLUME_SIDES];
      triangles +=
          free ? volume.data.counts.y : volume.items[VOLUME_CAPS] + volume.items[VOLUME_TURNED];
      ++casters;
    }
  m_mostWedges = std::max(m_mostWedges, wedges);
  m_mostCasters = std::max(m_mostCasters, casters);
  m_mostTriangles = std::max(m_mostTriangles, triangles);
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
  m_triangleBuffer =
      make("wedge triangles", m_mostTriangles * sizeof(gpu::WedgeTriangle), U::Storage);
  m_lightBlocks = make("wedge lights", m_mostLights * blockStride(m_context.device), U::Uniform);
}

void LightWedges::find(const ShadowVolumes& volumes, std::span<const LightVolumes* const> lights,
                       const Write& write) {
  const SceneView& view = m_context.view;
  m_wedges.clear();
  m_casters.clear();
  m_triangles.clear();
  m_lights.clear();
  m_loops.clear();
  m_count = m_everywhere = 0;
  m_reach = view.placed().camera().orthographic ? hullReach(view) : 0;
  const uint64_t stride = blockStride(m_context.device);
  std::vector<std::byte> blocks(lights.size() * stride);
  for (size_t i = 0; i < lights.size(); ++i) {
    addLight(volumes, *lights[i]);
    const gpu::WedgeLightData block{
        {numberInView(view, lights[i]->light), m_lights[i].casters.count, 0, 0}};
    std::memcpy(blocks.data() + i * stride, &block, sizeof block);
  }
  bind();
  if (lights.empty()) return;
  write(m_lightBlocks, blocks);
  write(m_casterBuffer, std::as_bytes(std::span(m_casters)));
  if (!m_wedges.empty()) write(m_wedgeBuffer, std::as_bytes(std::span(m_wedges)));
  if (!m_triangles.empty()) write(m_triangleBuffer, std::as_bytes(std::span(m_triangles)));
}

void LightWedges::addLight(const ShadowVolumes& volumes, const LightVolumes& light) {
  const SceneView& view = m_context.view;
  const WedgeLight shape = wedgeLight(view.placed().light(light.light), view.camera().eye);
  LightRange range{.firstLoops = m_loops.size()};
  range.wedges.first = nextStart(m_context.device, m_wedges);
  range.casters.first = nextStart(m_context.device, m_casters);
  range.triangles.first = nextStart(m_context.device, m_triangles);
  for (const CasterVolume& volume : light.casters) addCaster(volumes, volume, shape, range);
  range.wedges.count = uint32_t(m_wedges.size()) - range.wedges.first;
  range.casters.count = uint32_t(m_casters.size()) - range.casters.first;
  range.triangles.count = uint32_t(m_triangles.size()) - range.triangles.first;
  m_count += range.wedges.count;
  m_lights.push_back(range);
}

void LightWedges::addCaster(const ShadowVolumes& volumes, const CasterVolume& volume,
                            const WedgeLight& light, const LightRange& range) {
  const SceneView& view = m_context.view;
  const Mesh& mesh = view.scene().meshes[volume.mesh];
  const Box box = instanceBox(view.placed(), volume.instance, view.camera().eye);
  gpu::WedgeCaster caster{.sphere = glm::vec4(glm::vec3(box.center()), 1.0001 * box.radius()),
                          .parts = {uint32_t(m_wedges.size()) - range.wedges.first, 0,
                                    uint32_t(m_triangles.size()) - range.triangles.first, 0}};
  const std::span<const uint32_t> sides = volumes.items(volume, VOLUME_SIDES);
  std::vector<WedgeRange>& loops = m_loops.emplace_back();
  for (const SilhouetteLoop& loop : volumes.loops(volume)) {
    const ItemRange& its = loop[VOLUME_SIDES];
    loops.push_back(addEdges(volumes, volume, light, range, sides.subspan(its.first, its.count)));
    caster.parts.y += loops.back().count;
  }
  if (loops.empty()) caster.parts.y = addEdges(volumes, volume, light, range, sides).count;
  for (const uint32_t part : {VOLUME_CAPS, VOLUME_TURNED})
    for (const uint32_t triangle : volumes.items(volume, part)) {
      gpu::WedgeTriangle& made = m_triangles.emplace_back();
      for (size_t k = 0; k < 3; ++k) {
        const uint32_t corner = mesh.indices[3 * size_t(triangle) + k];
        made.corners[k] = glm::vec4(toRelative(volume.data, mesh.positions[corner]), 0);
      }
      ++caster.parts.w;
    }
  m_casters.push_back(caster);
}

WedgeRange LightWedges::addEdges(const ShadowVolumes& volumes, const CasterVolume& volume,
                                 const WedgeLight& light, const LightRange& range,
                                 std::span<const uint32_t> sides) {
  const Mesh& mesh = m_context.view.scene().meshes[volume.mesh];
  WedgeRange made{.first = uint32_t(m_wedges.size()) - range.wedges.first};
  for (size_t i = 0, end = 0; i < sides.size(); i = end) {
    while (end < sides.size() && sides[end] == sides[i]) ++end;
    const glm::uvec4 ends = volumes.edges(volume.mesh).mesh.edges[sides[i] >> 1].ends;
    const bool back = (sides[i] & 1) == 1;
    addWedge(light, volume, mesh.positions[back ? ends.y : ends.x],
             mesh.positions[back ? ends.x : ends.y], float(end - i));
    ++made.count;
  }
  return made;
}

void LightWedges::addWedge(const WedgeLight& light, const CasterVolume& volume, const glm::vec3& a,
                           const glm::vec3& b, float times) {
  const glm::vec3 start = toRelative(volume.data, a), end = toRelative(volume.data, b);
  const Wedge made = wedge(light, start, end);
  gpu::WedgeData data{
      .start = glm::vec4(start, times),
      .end = glm::vec4(end, made.holds ? 0 : 1),
      .hull = {},
      .throughStart = glm::vec4(gpu::lightThrough(volume.data, a), volume.data.extent.w),
      .throughEnd = glm::vec4(gpu::lightThrough(volume.data, b), volume.data.extent.w)};
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
  const rhi::Limits& limits = m_context.device.info().limits;
  const uint64_t stride = blockStride(m_context.device);
  for (size_t i = 0; i < m_lights.size(); ++i) {
    LightRange& light = m_lights[i];
    light.bindings = m_context.view.bindings();
    light.bindings.push_back(
        rhi::uniformAt(UNIFORM_TECHNIQUE, m_lightBlocks, i * stride, sizeof(gpu::WedgeLightData)));
    // Of this light alone: together they may be more than a device binds.
    const auto add = [&](uint32_t slot, const rhi::Buffer& buffer, const WedgeRange& range,
                         uint64_t size) {
      light.bindings.push_back(storageWindow(limits, STORAGE_TECHNIQUE + slot, buffer,
                                             range.first * size, std::max(range.count, 1u) * size)
                                   .binding);
    };
    add(0, m_wedgeBuffer, light.wedges, sizeof(gpu::WedgeData));
    add(1, m_casterBuffer, light.casters, sizeof(gpu::WedgeCaster));
    add(2, m_triangleBuffer, light.triangles, sizeof(gpu::WedgeTriangle));
  }
}

}  // namespace sb
