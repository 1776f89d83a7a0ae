// Where a mesh rises before itself: the sides of triangles from which a neighbour stands above
// their plane. Depth maps treat these apart (techniques/maps/shadow_maps.h); a flat mesh, and the
// outside of a convex one, have none.
#pragma once

#include <cstdint>
#include <vector>

#include "techniques/scene/placed_scene.h"

namespace sb {

/// Bits of a triangle: the side that its normal points to (counter-clockwise corners), the other.
constexpr uint8_t kConcaveFront = 1, kConcaveBack = 2;

struct ConcaveSides {
  std::vector<uint8_t> ofTriangle;  ///< bits
  /// Closed, and convex: concave on one side of its triangles alone, which is seen from within.
  bool convexSolid = false;
  bool any = false;
};

/// For each triangle of a mesh its concave sides. Corners at the same position are one, whatever
/// their attributes; triangles that go on in one plane share their sides, so that a tessellated
/// wall is as one quad. Heights that rounding of the positions explains are none. Other meshes, and
/// triangles that touch without a common edge, do not count.
ConcaveSides concaveSides(const Mesh& mesh);

/// Whether some light may see an instance rise before itself: a convex solid only from within.
/// Conservative: true inside the solid's box.
bool risesInLight(const PlacedScene& placed, uint32_t instance, const ConcaveSides& sides);

}  // namespace sb
