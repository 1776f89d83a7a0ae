#include "techniques/volumes/edges/edge_buffers.h"

namespace sb {

EdgeBuffers::EdgeBuffers(rhi::Device& device, const GpuScene& scene, const EdgeSlots& slots,
                         std::span<const uint32_t> meshes, Doubles doubles) {
  std::vector<gpu::EdgeData> all;
  std::map<uint32_t, size_t> firstEdge;
  for (const uint32_t mesh : meshes) {
    EdgeMesh edges = edgeMesh(scene.scene().meshes[mesh], doubles);
    firstEdge[mesh] = all.size();
    all.insert(all.end(), edges.edges.begin(), edges.edges.end());
    m_meshes[mesh] = {.edges = {},
                      .corners = {},
                      .positions = {},
                      .edgeCount = uint32_t(edges.edges.size()),
                      .triangleCount = scene.scene().meshes[mesh].triangleCount(),
                      .mesh = std::move(edges)};
  }
  const auto bytes = std::as_bytes(std::span(all));
  m_edges = device.createBuffer({.label = "mesh edges",
                                 .size = bytes.size() + 16,  // the last mesh may have no edge
                                 .use = rhi::BufferUse::Storage | rhi::BufferUse::CopyTarget});
  device.upload(m_edges, 0, bytes);
  const rhi::Limits& limits = device.info().limits;
  for (auto& [index, mesh] : m_meshes) {
    const GpuScene::MeshRange& range = scene.mesh(index);
    const uint64_t vertices = scene.scene().meshes[index].positions.size();
    mesh.edges =
        storageWindow(limits, slots.edges, m_edges, firstEdge[index] * sizeof(gpu::EdgeData),
                      mesh.edgeCount * sizeof(gpu::EdgeData));
    mesh.corners = storageWindow(limits, slots.corners, scene.indices(),
                                 uint64_t(range.firstIndex) * 4, uint64_t(range.indexCount) * 4);
    mesh.positions = storageWindow(limits, slots.positions, scene.positions(),
                                   uint64_t(range.vertexOffset) * 12, vertices * 12);
  }
}

}  // namespace sb
