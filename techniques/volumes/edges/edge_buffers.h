// Edges, corners and positions of a scene's meshes as compute and geometry shaders read them.
#pragma once

#include "techniques/draw/scene/gpu_scene.h"
#include "techniques/draw/scene/storage_window.h"
#include "techniques/volumes/edges/edge_mesh.h"

namespace sb {

/// Storage slots that a technique lends.
struct EdgeSlots {
  uint32_t edges;      ///< EdgeData[] (shaders/common/shared_edges.h)
  uint32_t corners;    ///< uint[]: three vertices a triangle
  uint32_t positions;  ///< float[]: three coordinates a vertex, mesh space
};

class EdgeBuffers {
 public:
  EdgeBuffers() = default;
  /// Of some meshes of the scene, which must outlive this. Throws rhi::Error when the device
  /// refuses.
  EdgeBuffers(rhi::Device& device, const GpuScene& scene, const EdgeSlots& slots,
              std::span<const uint32_t> meshes, Doubles doubles = Doubles::Each);

  /// One mesh: numbers of vertices and triangles in its edges are its own.
  struct MeshEdges {
    StorageWindow edges, corners, positions;
    uint32_t edgeCount = 0;
    uint32_t triangleCount = 0;
    EdgeMesh mesh;  ///< the same on the CPU
  };
  const MeshEdges& of(uint32_t mesh) const { return m_meshes.at(mesh); }

 private:
  rhi::Buffer m_edges;
  std::map<uint32_t, MeshEdges> m_meshes;
};

}  // namespace sb
