// Penumbra wedges as C++ makes and shaders draw them (spec 08): the edges of silhouettes and the
// hulls of their penumbrae, the casters that they belong to.
#ifndef SHADOWBENCH_SHARED_WEDGE_H
#define SHADOWBENCH_SHARED_WEDGE_H

#ifdef __cplusplus
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
namespace sb::gpu {
using vec4 = glm::vec4;
using uvec4 = glm::uvec4;
using uint = uint32_t;
#endif

// Where volumes and wedges are added up: nowhere; in one channel; counts of volumes, shares and edges
// about which they may disagree in one each; in bytes, volumes entered and left, what uncovers and
// what hides.
#define SUMS_NONE 0u
#define SUMS_TOGETHER 1u
#define SUMS_APART 2u
#define SUMS_BYTES 3u

#define WEDGE_CORNERS 6
#define WEDGE_VERTICES 24u
#define WEDGE_HALF_VERTICES 42u
// Corners of a hull's triangles, counter-clockwise from outside, four bits each, the first lowest:
// before, behind, at the ends, and what lies at infinity.
#define WEDGE_FACES0 0x51140420u
#define WEDGE_FACES1 0x12300313u
#define WEDGE_FACES2 0x45253254u

struct WedgeData {
  vec4 start;  // of the edge, relative to the eye, the occluder to its left as the light sees it;
               // w: how often it counts
  vec4 end;    // w: 1 if the hull is all that is seen
  vec4 hull[WEDGE_CORNERS];  // the edge's ends (w 1), the second moved toward the light or away; then
                             // ways (w 0), before and behind from the first, from the second
  vec4 throughStart;  // the way of light through the ends, as sides of volumes have it; w: as
  vec4 throughEnd;    // VolumeData::extent
};

// A triangle that casts; corners relative to the eye, to the bits of the edges' ends.
struct WedgeTriangle {
  vec4 corners[3];
};

// A caster in a light.
struct WedgeCaster {
  vec4 sphere;  // around it, relative to the eye; w: radius
  uvec4 parts;  // of those of the light; x: its first wedge, y: how many; z, w: triangles
};

// For the passes of one light.
struct WedgeLightData {
  uvec4 ids;  // x: the light among those in view, y: how many casters
};

#ifdef __cplusplus
static_assert(offsetof(WedgeData, end) == 16 && offsetof(WedgeData, hull) == 32 &&
              offsetof(WedgeData, throughStart) == 128 && offsetof(WedgeData, throughEnd) == 144 &&
              sizeof(WedgeData) == 160);
static_assert(sizeof(WedgeTriangle) == 48);
static_assert(offsetof(WedgeCaster, parts) == 16 && sizeof(WedgeCaster) == 32);
static_assert(sizeof(WedgeLightData) == 16);
#endif

// Corner of a hull at a vertex of its triangles.
#ifdef __cplusplus
inline
#endif
uint wedgeCorner(uint vertex) {
  uint faces = vertex < 8u ? WEDGE_FACES0 : vertex < 16u ? WEDGE_FACES1 : WEDGE_FACES2;
  return faces >> 4u * (vertex & 7u) & 15u;
}

#ifdef __cplusplus
}  // namespace sb::gpu
#endif

#endif
