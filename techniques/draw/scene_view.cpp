#include "techniques/draw/scene_view.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "shaders/common/shared_slots.h"
#include "techniques/draw/view_path.h"
#include "techniques/scene/light_data.h"

namespace sb {
namespace {

/// All but where it stands relative to the eye.
gpu::InstanceData instanceData(const PlacedScene& placed, uint32_t index,
                               const GpuScene::MeshRange& range) {
  const Instance& instance = placed.scene().instances[index];
  const glm::dmat3 linear(placed.toWorld(index));
  // Cofactors, not the inverse transpose: no division, and right for singular transforms too.
  const glm::dmat3 cofactor(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                            glm::cross(linear[0], linear[1]));
  gpu::InstanceData d{};
  glm::vec4* rows = &d.toRelative0;
  glm::vec4* normals = &d.normal0;
  for (int r = 0; r < 3; ++r) {
    rows[r] = glm::vec4(glm::dvec4(linear[0][r], linear[1][r], linear[2][r], 0));
    normals[r] = glm::vec4(glm::dvec4(cofactor[0][r], cofactor[1][r], cofactor[2][r], 0));
  }
  d.normal0.w = glm::determinant(linear) < 0 ? -1.0f : 1.0f;
  d.ids = {index, instance.key, range.firstTriangle, placed.scene().meshes[instance.mesh].key};
  return d;
}

rhi::Buffer makeStorage(rhi::Device& device, const char* label, uint64_t bytes,
                        rhi::BufferUse use = rhi::BufferUse::Storage) {
  return device.createBuffer({.label = label,
                              .size = std::max<uint64_t>(16, bytes),
                              .use = use | rhi::BufferUse::CopyTarget});
}

/// Lists of lights are read from uniform blocks where they fit, else from storage.
constexpr rhi::BufferUse kListUse = rhi::BufferUse::Uniform | rhi::BufferUse::Storage;

/// Elements of a block that holds `count`: one, or a power of four, so that few pipelines serve all
/// scenes.
uint32_t blockLength(size_t count) {
  uint32_t length = 1;
  while (length < count) length *= 4;
  return length;
}

template <class T>
std::span<const std::byte> bytesOf(const std::vector<T>& data) {
  return std::as_bytes(std::span(data));
}

}  // namespace

SceneView::SceneView(rhi::Device& device, const GpuScene& gpuScene, const Effects& effects,
                     rhi::Extent2D size, uint32_t seed)
    : m_gpu(gpuScene),
      m_effects(effects),
      m_moving(gpuScene.scene()),
      m_placed(gpuScene.scene()),
      m_shown(&effects),
      m_size(size),
      m_seed(seed),
      m_mostUniform(std::min<uint64_t>(kMostUniformBytes, device.info().limits.maxUniformRange)) {
  for (uint32_t i = 0; i < scene().instances.size(); ++i)
    m_instanceData.push_back(instanceData(m_placed, i, m_gpu.mesh(scene().instances[i].mesh)));
  createBuffers(device);
  look(scene(), m_effects);
  writeAll(uploadsTo(device));
}

void SceneView::createBuffers(rhi::Device& device) {
  copyInstances(device, 1);
  m_frame = makeStorage(device, "view frame", sizeof(gpu::FrameData), rhi::BufferUse::Uniform);
  // Only lights that touch the view exist for the shaders.
  m_lights =
      makeStorage(device, "view lights", uint64_t(lightCount()) * sizeof(gpu::LightData), kListUse);
  m_shadowViews = makeStorage(device, "view shadow views", sizeof(gpu::ShadowViewData), kListUse);
  if (m_gpu.everCoplanar()) {
    const CameraMatrices any = cameraMatrices(scene().camera(), aspect());
    uint64_t bytes = 0;
    for (uint32_t k = 0; k < steps(); ++k) {
      const std::vector<uint32_t> words = m_gpu.coplanar(k).words(any, m_size.width, m_size.height);
      bytes = std::max<uint64_t>(bytes, bytesOf(words).size());
    }
    m_coplanar = makeStorage(device, "view coplanar surfaces", bytes);
  }
  bind();
}

void SceneView::bind() {
  const bool stored = lightsInStorage();
  m_bindings = {rhi::uniformAt(UNIFORM_FRAME, m_frame, 0, sizeof(gpu::FrameData)),
                rhi::uniformAt(UNIFORM_LIGHTS, m_lights, 0,
                               (stored ? 1 : lightCount()) * sizeof(gpu::LightData)),
                rhi::uniformAt(UNIFORM_SHADOW_VIEWS, m_shadowViews, 0,
                               (stored ? 1 : viewCount()) * sizeof(gpu::ShadowViewData)),
                rhi::storageAt(STORAGE_LIGHTS, m_lights),
                rhi::storageAt(STORAGE_SHADOW_VIEWS, m_shadowViews),
                // Scenes without such surfaces do not read it.
                rhi::storageAt(STORAGE_COPLANAR, m_coplanar ? m_coplanar.id() : m_lights.id()),
                m_gpu.triangles()};
}

SceneView::Write SceneView::uploadsTo(rhi::Device& device) {
  return [&device](rhi::BufferId buffer, uint64_t at, std::span<const std::byte> bytes) {
    device.upload(buffer, at, bytes);
  };
}

void SceneView::look(PlacedScene placed, const ViewEffects& shown) {
  m_placed = std::move(placed);
  m_shown = &shown;
  m_camera = cameraMatrices(m_placed.camera(), aspect());
  m_rays = cameraRays(m_placed.camera(), m_size.width, m_size.height);
  for (const uint32_t i : m_moving.instances)
    m_instanceData[i] = instanceData(m_placed, i, m_gpu.mesh(scene().instances[i].mesh));
  for (uint32_t i = 0; i < m_instanceData.size(); ++i) {
    const glm::vec3 place(glm::dvec3(m_placed.toWorld(i)[3]) - m_camera.eye);
    glm::vec4* rows = &m_instanceData[i].toRelative0;
    for (int r = 0; r < 3; ++r) rows[r].w = place[r];
  }
}

void SceneView::look(uint32_t step) {
  look(PlacedScene(scene(), step), m_effects.steps[step]);
  m_step = step;
  if (m_fit) m_lightViews = placeViews(m_united, fitLights(m_placed, *m_shown, aspect(), *m_fit));
}

void SceneView::moveTo(rhi::CommandList& commands, uint32_t step) {
  look(step);
  const Write write = [&](rhi::BufferId buffer, uint64_t at, std::span<const std::byte> bytes) {
    if (!bytes.empty()) commands.write(buffer, at, bytes);
  };
  if (m_moving.camera) return writeAll(write);
  // Relative to an eye that stands, so does what stands.
  const std::vector<uint32_t>& moved = m_moving.instances;
  for (size_t i = 0, end = 0; i < moved.size(); i = end) {
    while (end < moved.size() && moved[end] - moved[i] == end - i) ++end;
    writeInstances(write, moved[i], uint32_t(end - i));
  }
  if (!moved.empty()) writeCoplanar(write);
  writeFrame(write);
  writeLights(write);
}

void SceneView::alongPath(rhi::Device& device, const std::function<void()>& visit) {
  for (uint32_t k = 0; k < m_effects.steps.size(); ++k) {
    look(k);
    writeAll(uploadsTo(device));
    visit();
  }
  if (m_effects.steps.empty()) return visit();
  look(scene(), m_effects);
  m_lightViews = m_united;
  writeAll(uploadsTo(device));
}

void SceneView::fitLightViews(rhi::Device& device, const LightFitSettings& settings) {
  m_fit = settings;
  std::vector<std::vector<LightView>> steps;
  for (uint32_t k = 0; k < m_effects.steps.size(); ++k)
    steps.push_back(fitLights(PlacedScene(scene(), k), m_effects.steps[k], aspect(), settings));
  if (steps.empty()) steps.push_back(fitLights(scene(), m_effects, aspect(), settings));
  m_lightViews = m_united = uniteViews(steps);
  const auto filled = [](const std::vector<LightView>& views) {
    return std::ranges::count_if(views, [](const LightView& v) { return !v.empty(); });
  };
  m_firstHasAll = filled(steps.front()) == filled(m_united);
  m_shadowViews =
      makeStorage(device, "view shadow views", viewCount() * sizeof(gpu::ShadowViewData), kListUse);
  bind();
  writeLights(uploadsTo(device));
}

void SceneView::setSeed(rhi::Device& device, uint32_t seed) {
  m_seed = seed;
  writeFrame(uploadsTo(device));
}

void SceneView::writeAll(const Write& write) {
  writeInstances(write, 0, uint32_t(m_instanceData.size()));
  writeCoplanar(write);
  writeFrame(write);
  writeLights(write);
}

void SceneView::writeCoplanar(const Write& write) const {
  if (!m_coplanar) return;
  const CoplanarSurfaces& surfaces = m_gpu.coplanar(m_step);
  write(m_coplanar, 0, bytesOf(surfaces.words(m_camera, m_size.width, m_size.height)));
}

void SceneView::copyInstances(rhi::Device& device, uint32_t copies) {
  auto [it, isNew] = m_instances.try_emplace(copies);
  if (!isNew) return;
  it->second = makeStorage(device, "view instances", bytesOf(m_instanceData).size() * copies,
                           rhi::BufferUse::Vertex);
  writeInstances(uploadsTo(device), 0, uint32_t(m_instanceData.size()));
}

void SceneView::writeInstances(const Write& write, uint32_t first, uint32_t count) const {
  for (const auto& [copies, buffer] : m_instances) {
    std::vector<gpu::InstanceData> records;
    for (const gpu::InstanceData& instance : std::span(m_instanceData).subspan(first, count))
      for (uint32_t copy = 0; copy < copies; ++copy) records.emplace_back(instance).order.y = copy;
    write(buffer, uint64_t(first) * copies * sizeof(gpu::InstanceData), bytesOf(records));
  }
}

uint32_t SceneView::lightCount() const {
  return blockLength(size_t(std::ranges::count_if(m_effects.lights, &LightEffects::touchesView)));
}

uint32_t SceneView::viewCount() const { return blockLength(m_united.size()); }

bool SceneView::lightsInStorage() const {
  return lightCount() * sizeof(gpu::LightData) > m_mostUniform ||
         viewCount() * sizeof(gpu::ShadowViewData) > m_mostUniform;
}

std::vector<rhi::SpecConstant> SceneView::constants() const {
  const bool stored = lightsInStorage();
  return {{5, stored ? 1 : lightCount()}, {6, stored ? 1 : viewCount()}, {7, stored}};
}

void SceneView::writeFrame(const Write& write) const {
  const auto lights = std::ranges::count_if(m_shown->lights, &LightEffects::touchesView);
  const gpu::FrameData frame{.viewProjection = glm::mat4(m_camera.viewProjection),
                             .ambient = glm::vec4(scene().ambient, 0),
                             .counts = {uint32_t(lights), m_size.width, m_size.height, m_seed},
                             .eye = glm::vec4(m_camera.eye, 1),
                             .sky = glm::vec4(scene().sky, 0),
                             .rayOrigin = glm::vec4(m_rays.origin, 0),
                             .rayRight = glm::vec4(m_rays.right, 0),
                             .rayUp = glm::vec4(m_rays.up, 0),
                             .rayForward = glm::vec4(m_rays.forward, m_rays.parallel ? 1 : 0),
                             .depthToDistance = glm::vec4(m_rays.depthToDistance)};
  write(m_frame, 0, std::as_bytes(std::span(&frame, 1)));
}

bool SceneView::casterRises() const {
  const auto rises = [&](uint32_t i) { return m_gpu.rises(i, m_step); };
  return std::ranges::any_of(m_lightViews, [&](const LightView& view) {
    return std::ranges::any_of(view.opaque, rises) || std::ranges::any_of(view.perforated, rises) ||
           std::ranges::any_of(view.translucent, rises);
  });
}

void SceneView::writeLights(const Write& write) const {
  std::vector<gpu::LightData> lights;
  std::vector<gpu::ShadowViewData> shadowViews;
  const bool rises = casterRises();
  for (const LightView& view : m_lightViews)
    shadowViews.push_back(shadowViewData(view, *m_fit, rises));
  for (const LightEffects& effects : m_shown->lights) {
    if (!effects.touchesView) continue;
    gpu::LightData d = lightData(m_placed.light(effects.light), effects.light, m_camera.eye);
    const auto first = std::ranges::find(m_lightViews, effects.light, &LightView::light);
    if (effects.casts() && first != m_lightViews.end()) {
      d.ids.y = uint32_t(first - m_lightViews.begin());
      d.ids.z = uint32_t(std::ranges::count(m_lightViews, effects.light, &LightView::light));
    }
    lights.push_back(d);
  }
  write(m_lights, 0, bytesOf(lights));
  write(m_shadowViews, 0, bytesOf(shadowViews));
}

}  // namespace sb
