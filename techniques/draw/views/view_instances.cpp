#include "techniques/draw/views/view_instances.h"

#include <algorithm>

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

}  // namespace

ViewInstances::ViewInstances(const GpuScene& gpu) : m_gpu(gpu) {
  const std::vector<Instance>& instances = gpu.scene().instances;
  for (uint32_t i = 0; i < instances.size(); ++i)
    m_data.push_back(instanceData(gpu.scene(), i, gpu.mesh(instances[i].mesh)));
}

void ViewInstances::place(const PlacedScene& placed, const glm::dvec3& eye,
                          std::span<const uint32_t> moved) {
  for (const uint32_t i : moved)
    m_data[i] = instanceData(placed, i, m_gpu.mesh(placed.scene().instances[i].mesh));
  for (uint32_t i = 0; i < m_data.size(); ++i) {
    const glm::vec3 place(glm::dvec3(placed.toWorld(i)[3]) - eye);
    glm::vec4* rows = &m_data[i].toRelative0;
    for (int r = 0; r < 3; ++r) rows[r].w = place[r];
  }
}

void ViewInstances::copy(rhi::Device& device, uint32_t copies) {
  auto [it, isNew] = m_buffers.try_emplace(copies);
  if (!isNew) return;
  it->second = device.createBuffer(
      {.label = "view instances",
       .size = std::max<uint64_t>(16, m_data.size() * sizeof(gpu::InstanceData) * copies),
       .use = rhi::BufferUse::Vertex | rhi::BufferUse::CopyTarget});
  writeAll(uploadsTo(device));
}

void ViewInstances::writeAll(const BufferWrite& write) const {
  writeRun(write, 0, uint32_t(m_data.size()));
}

void ViewInstances::write(const BufferWrite& write, std::span<const uint32_t> instances) const {
  for (size_t i = 0, end = 0; i < instances.size(); i = end) {
    while (end < instances.size() && instances[end] - instances[i] == end - i) ++end;
    writeRun(write, instances[i], uint32_t(end - i));
  }
}

void ViewInstances::writeRun(const BufferWrite& write, uint32_t first, uint32_t count) const {
  for (const auto& [copies, buffer] : m_buffers) {
    std::vector<gpu::InstanceData> records;
    for (const gpu::InstanceData& instance : std::span(m_data).subspan(first, count))
      for (uint32_t copy = 0; copy < copies; ++copy) records.emplace_back(instance).order.y = copy;
    write(buffer, uint64_t(first) * copies * sizeof(gpu::InstanceData),
          std::as_bytes(std::span(records)));
  }
}

}  // namespace sb
