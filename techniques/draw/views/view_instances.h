// The records of a scene's instances, relative to the eye, and the vertex buffers that hold them.
#pragma once

#include <map>

#include "shaders/common/shared_types.h"
#include "techniques/draw/scene/gpu_scene.h"
#include "techniques/draw/views/buffer_write.h"
#include "techniques/scene/placed_scene.h"

namespace sb {

class ViewInstances {
 public:
  /// As they stand in the scene, not yet relative to any eye. `gpu` must outlive the records.
  explicit ViewInstances(const GpuScene& gpu);

  /// All of them relative to `eye`; those of `moved` stand elsewhere too.
  void place(const PlacedScene& placed, const glm::dvec3& eye, std::span<const uint32_t> moved);
  const gpu::InstanceData& operator[](uint32_t index) const { return m_data[index]; }

  /// A vertex buffer of `copies` of each record in turn, numbered.
  rhi::BufferId buffer(uint32_t copies) const { return m_buffers.at(copies); }
  /// Makes one with that many copies and fills it; from then on it is written like the others.
  void copy(rhi::Device& device, uint32_t copies);
  void writeAll(const BufferWrite& write) const;
  /// Of some, in scene order.
  void write(const BufferWrite& write, std::span<const uint32_t> instances) const;

 private:
  /// So many from the first on.
  void writeRun(const BufferWrite& write, uint32_t first, uint32_t count) const;

  const GpuScene& m_gpu;
  std::vector<gpu::InstanceData> m_data;
  std::map<uint32_t, rhi::Buffer> m_buffers;  ///< by copies
};

}  // namespace sb
