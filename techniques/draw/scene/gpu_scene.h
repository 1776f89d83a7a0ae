// A scene's unchanging data on one device: vertices, indices, triangle records, materials,
// textures; and what analysis knows of every step of its path. Cells of the same scene share it.
// What depends on the camera is in SceneView.
#pragma once

#include <vector>

#include "backends/rhi/device.h"
#include "techniques/scene/geometry/concave_sides.h"
#include "techniques/scene/geometry/coplanar_surfaces.h"

namespace sb {

class GpuScene {
 public:
  /// Uploads everything and waits. The scene must outlive this object. Throws rhi::Error when the
  /// device refuses (out of memory, texture too large).
  GpuScene(rhi::Device& device, const Scene& scene);

  const Scene& scene() const { return m_scene; }
  bool textured() const { return m_textured; }

  struct MeshRange {
    uint32_t firstIndex = 0;
    uint32_t indexCount = 0;
    int32_t vertexOffset = 0;
    uint32_t firstTriangle = 0;  ///< into the triangle records
  };
  const MeshRange& mesh(uint32_t index) const { return m_meshes[index]; }
  /// A light may see an instance rise before itself at a step (concave_sides.h); at any.
  bool rises(uint32_t instance, uint32_t step) const { return atStep(m_rises, step)[instance]; }
  bool everRises(uint32_t instance) const;

  /// Surfaces that lie over others in one plane at a step; whether there are any at one.
  const CoplanarSurfaces& coplanar(uint32_t step) const { return atStep(m_coplanar, step); }
  bool everCoplanar() const;

  /// Vertex buffer 0: positions (12 bytes); buffer 1, with attributes: the others; the last:
  /// records of instances (gpu::InstanceData), which SceneView has. Positions and indices are
  /// storage, too.
  rhi::BufferId positions() const { return m_positions; }
  rhi::BufferId attributes() const { return m_attributes; }
  rhi::BufferId indices() const { return m_indices; }
  static std::vector<rhi::VertexBufferLayout> vertexLayout(bool withAttributes);
  static std::vector<rhi::VertexAttribute> vertexAttributes(bool withAttributes);

  /// Slots that never change: a material, triangles, and a material's textures.
  rhi::Binding material(uint32_t index) const;
  rhi::Binding triangles() const;
  const std::vector<rhi::Binding>& textures(uint32_t material) const {
    return m_textureBindings[material];
  }

 private:
  /// Of what is the same in all steps there is one.
  template <class T>
  static const T& atStep(const std::vector<T>& steps, uint32_t step) {
    return steps[steps.size() > 1 ? step : 0];
  }
  void analyseSteps(const std::vector<ConcaveSides>& sides);
  void uploadMeshes(rhi::Device& device);
  void uploadMaterials(rhi::Device& device);

  const Scene& m_scene;
  std::vector<CoplanarSurfaces> m_coplanar;
  bool m_textured = false;
  std::vector<MeshRange> m_meshes;
  std::vector<std::vector<bool>> m_rises;
  rhi::Buffer m_positions, m_attributes, m_indices, m_triangles, m_materials;
  uint64_t m_materialStride = 256;
  std::vector<rhi::Texture> m_textures;
  std::vector<rhi::Sampler> m_samplers;
  std::vector<std::vector<rhi::Binding>> m_textureBindings;
};

}  // namespace sb
