// Penumbra wedges as C++ makes and shaders draw them (spec 08): the edges of silhouettes and the
// hulls of their penumbrae, the casters that they belong to.
#ifndef SHADOWBENCH_SHARED_WEDGE_H
#define SHADOWBENCH_SHARED_WEDGE_H

#ifdef __cplusplus
#include "shaders/common/shared_volume.h"
namespace sb::gpu {
#endif  // shaders: after common/shared_volume.h

#define WEDGE_CORNERS 6
#define WEDGE_VERTICES 24u
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
};

// A caster in a light.
struct WedgeCaster {
  VolumeData volume;  // first.y, first.z: its corners and positions among those of all meshes
  vec4 sphere;        // around it, relative to the eye; w: radius
  uvec4 wedges;       // x: the first of it, y: how many
};

// The casters of a light, for the passes of one light.
struct WedgeLightData {
  uvec4 ids;  // x: the light among those in view, y: first caster, z: how many
};

#ifdef __cplusplus
static_assert(offsetof(WedgeData, end) == 16 && offsetof(WedgeData, hull) == 32 &&
              sizeof(WedgeData) == 128);
static_assert(offsetof(WedgeCaster, sphere) == 144 && offsetof(WedgeCaster, wedges) == 160 &&
              sizeof(WedgeCaster) == 176);
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
