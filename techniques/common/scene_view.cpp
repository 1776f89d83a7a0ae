#include "techniques/common/scene_view.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "shaders/common/shared_slots.h"
#include "techniques/common/light_data.h"

namespace sb {
namespace {

gpu::InstanceData instanceData(const Scene& scene, const Instance& instance,
                               const GpuScene::MeshRange& range, const glm::dvec3& eye) {
  const glm::dmat3 linear(instance.toWorld);
  const glm::dvec3 translation = glm::dvec3(instance.toWorld[3]) - eye;
  // Cofactors, not the inverse transpose: no division, and right for singular transforms too.
  const glm::dmat3 cofactor(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                            glm::cross(linear[0], linear[1]));
  gpu::InstanceData d{};
  glm::vec4* rows = &d.toRelative0;
  glm::vec4* normals = &d.normal0;
  for (int r = 0; r < 3; ++r) {
    rows[r] = glm::vec4(glm::dvec4(linear[0][r], linear[1][r], linear[2][r], translation[r]));
    normals[r] = glm::vec4(glm::dvec4(cofactor[0][r], cofactor[1][r], cofactor[2][r], 0));
  }
  d.normal0.w = glm::determinant(linear) < 0 ? -1.0f : 1.0f;
  const Mesh& mesh = scene.meshes[instance.mesh];
  d.ids = {mesh.material, instance.key, range.firstTriangle, mesh.key};
  return d;
}

rhi::Buffer makeStorage(rhi::Device& device, const char* label, uint64_t bytes,
                        rhi::BufferUse use = rhi::BufferUse::Storage) {
  return device.createBuffer({.label = label,
                              .size = std::max<uint64_t>(16, bytes),
                              .use = use | rhi::BufferUse::CopyTarget});
}

template <class T>
void uploadAll(rhi::Device& device, rhi::BufferId buffer, const std::vector<T>& data) {
  device.upload(buffer, 0, std::as_bytes(std::span(data)));
}

}  // namespace

SceneView::SceneView(rhi::Device& device, const GpuScene& gpuScene, const Effects& effects,
                     rhi::Extent2D size, uint32_t seed)
    : m_gpu(gpuScene), m_effects(effects), m_size(size), m_seed(seed) {
  const Scene& s = scene();
  m_camera = cameraMatrices(s.camera(), aspect());
  const uint64_t align = device.info().limits.uniformAlignment;
  m_drawStride = (sizeof(gpu::DrawData) + align - 1) / align * align;

  std::vector<gpu::InstanceData> instances;
  std::vector<std::byte> draws(std::max<size_t>(1, s.instances.size()) * m_drawStride);
  for (uint32_t i = 0; i < s.instances.size(); ++i) {
    const Instance& instance = s.instances[i];
    instances.push_back(instanceData(s, instance, m_gpu.mesh(instance.mesh), m_camera.eye));
    const gpu::DrawData draw{.ids = {i, NO_SHADOW, 0, 0}};
    std::memcpy(draws.data() + drawOffset(i), &draw, sizeof draw);
  }
  m_draws = makeStorage(device, "view draws", draws.size(), rhi::BufferUse::Uniform);
  uploadAll(device, m_draws, draws);
  m_instances = makeStorage(device, "view instances", instances.size() * sizeof instances[0]);
  uploadAll(device, m_instances, instances);
  m_frame = makeStorage(device, "view frame", sizeof(gpu::FrameData), rhi::BufferUse::Uniform);
  uploadLights(device, {});
}

void SceneView::setSeed(rhi::Device& device, uint32_t seed) {
  m_seed = seed;
  uploadFrame(device);
}

void SceneView::uploadFrame(rhi::Device& device) {
  const gpu::FrameData frame{.viewProjection = glm::mat4(m_camera.viewProjection),
                             .ambient = glm::vec4(scene().ambient, 0),
                             .counts = {m_lightCount, m_size.width, m_size.height, m_seed}};
  device.upload(m_frame, 0, std::as_bytes(std::span(&frame, 1)));
}

void SceneView::setShadowViews(rhi::Device& device, const std::vector<LightView>& views) {
  uploadLights(device, views);
}

void SceneView::uploadLights(rhi::Device& device, const std::vector<LightView>& views) {
  // Only lights that touch the view exist for the shaders.
  std::vector<gpu::LightData> lights;
  std::vector<gpu::ShadowViewData> shadowViews;
  for (const LightView& view : views) shadowViews.push_back(view.data);
  for (const LightEffects& effects : m_effects.lights) {
    if (!effects.touchesView) continue;
    gpu::LightData d = lightData(scene().lights[effects.light], effects.light, m_camera.eye);
    const auto first = std::ranges::find(views, effects.light, &LightView::light);
    if (first != views.end()) {
      d.ids.y = uint32_t(first - views.begin());
      d.ids.z = uint32_t(std::ranges::count(views, effects.light, &LightView::light));
    }
    lights.push_back(d);
  }
  m_lightCount = uint32_t(lights.size());
  uploadFrame(device);
  m_lights = makeStorage(device, "view lights", lights.size() * sizeof(gpu::LightData));
  uploadAll(device, m_lights, lights);
  m_shadowViews =
      makeStorage(device, "view shadow views", shadowViews.size() * sizeof(gpu::ShadowViewData));
  uploadAll(device, m_shadowViews, shadowViews);
  m_bindings = {rhi::uniformAt(UNIFORM_DRAW, m_draws, 0, sizeof(gpu::DrawData)),
                rhi::uniformAt(UNIFORM_FRAME, m_frame, 0, sizeof(gpu::FrameData)),
                rhi::storageAt(STORAGE_INSTANCES, m_instances),
                rhi::storageAt(STORAGE_LIGHTS, m_lights),
                rhi::storageAt(STORAGE_SHADOW_VIEWS, m_shadowViews),
                m_gpu.materials(),
                m_gpu.triangles()};
}

}  // namespace sb
