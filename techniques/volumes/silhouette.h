// What a shadow volume consists of, found on the CPU: the items that
// shaders/common/volume_vertex.glsl makes vertices of.
#pragma once

#include <array>
#include <map>

#include "techniques/volumes/caster_volume.h"

namespace sb {

/// Items of each part: of the sides twice an edge, and one more where it runs from high to low, as
/// often as it is needed; of the caps triangles.
using Silhouette = std::array<std::vector<uint32_t>, VOLUME_PARTS>;

/// Of the parts that the volume has. Bit by bit what shaders find.
Silhouette silhouette(const Mesh& mesh, const EdgeMesh& edges, const gpu::VolumeData& volume);

/// Silhouettes of all volumes, found again where light or caster have moved.
class Silhouettes {
 public:
  /// Of a volume in a light (index into Scene::lights); until the next call for the two.
  const Silhouette& of(uint32_t light, const CasterVolume& volume, const Mesh& mesh,
                       const EdgeMesh& edges);

 private:
  struct Known {
    gpu::VolumeData volume;
    Silhouette items;
  };
  std::map<std::pair<uint32_t, uint32_t>, Known> m_known;  ///< by light and instance
};

}  // namespace sb
