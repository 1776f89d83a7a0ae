// Which triangles of a scene lie over one another in one plane, one of them translucent at least,
// and in what order they are layers (spec 16): opaque ones first, then by their keys. Rasterised,
// two tessellations of one plane have depths that differ by chance; so all triangles of a plane
// take their depth from that plane, and each lies as many steps of a float behind it as there are
// surfaces before it. Computed once for
// each place of the instances; the planes as the camera sees them, for each camera.
#pragma once

#include <vector>

#include "techniques/scene/camera.h"
#include "techniques/scene/geometry/coplanar.h"

namespace sb {

class CoplanarSurfaces {
 public:
  CoplanarSurfaces() = default;
  explicit CoplanarSurfaces(const PlacedScene& placed);

  bool empty() const { return m_members.empty(); }
  /// What shaders/common/layer_depth.glsl reads: by instance, the place of its triangles' entries or
  /// 0; by triangle, the place of its record or 0; records of A, B, C (floats: depth = A x + B y + C
  /// at a pixel's centre) and rank, with bit 16 where an opaque surface lies there too. Its length does not depend on the camera.
  std::vector<uint32_t> words(const CameraMatrices& camera, uint32_t width, uint32_t height) const;

 private:
  struct Member {
    uint32_t instance = 0, triangle = 0, rank = 0;
    bool inOpaque = false;  ///< an opaque one lies there too
    glm::dvec3 normal, point;  ///< the plane of its group; `point` in the world
  };
  const Scene* m_scene = nullptr;
  std::vector<Member> m_members;
};

}  // namespace sb
