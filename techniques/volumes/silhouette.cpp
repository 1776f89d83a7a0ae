#include "techniques/volumes/silhouette.h"

#include <cstdlib>

namespace sb {
namespace {

/// Of what a silhouette depends on: not on where the camera is.
bool sameSilhouette(const gpu::VolumeData& a, const gpu::VolumeData& b) {
  return glm::vec3(a.row0) == glm::vec3(b.row0) && glm::vec3(a.row1) == glm::vec3(b.row1) &&
         glm::vec3(a.row2) == glm::vec3(b.row2) && a.light == b.light && a.counts == b.counts &&
         a.vertices == b.vertices;
}

}  // namespace

Silhouette silhouette(const Mesh& mesh, const EdgeMesh& edges, const gpu::VolumeData& volume) {
  const auto corner = [&](uint32_t t, uint32_t c) {
    return mesh.positions[mesh.indices[3 * size_t(t) + c]];
  };
  std::vector<int> casts(mesh.triangleCount());
  for (const uint32_t t : edges.triangles)
    casts[t] = gpu::casts(volume, corner(t, 0), corner(t, 1), corner(t, 2));
  Silhouette items;
  for (uint32_t e = 0; e < edges.edges.size(); ++e) {
    const int m = edgeMultiplicity(edges.edges[e], [&](uint32_t t) { return casts[t]; });
    items[VOLUME_SIDES].insert(items[VOLUME_SIDES].end(), size_t(std::abs(m)),
                               2 * e + (m < 0 ? 1 : 0));
  }
  for (const uint32_t t : edges.triangles) {
    const uint32_t part = casts[t] > 0 ? VOLUME_CAPS : VOLUME_TURNED;
    if (casts[t] != 0 && (volume.vertices.z >> part & 1)) items[part].push_back(t);
  }
  return items;
}

const Silhouette& Silhouettes::of(uint32_t light, const CasterVolume& volume, const Mesh& mesh,
                                  const EdgeMesh& edges) {
  auto [it, isNew] = m_known.try_emplace({light, volume.instance});
  Known& known = it->second;
  if (isNew || !sameSilhouette(known.volume, volume.data))
    known = {volume.data, silhouette(mesh, edges, volume.data)};
  return known.items;
}

}  // namespace sb
