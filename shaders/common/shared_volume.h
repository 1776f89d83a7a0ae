// The shadow volume of one caster and one light (spec 07): what C++ fills and shaders read, and
// which of its triangles cast, asked in one place so that CPU and GPU agree to the last bit.
#ifndef SHADOWBENCH_SHARED_VOLUME_H
#define SHADOWBENCH_SHARED_VOLUME_H

#ifdef __cplusplus
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
namespace sb::gpu {
using vec3 = glm::vec3;
using vec4 = glm::vec4;
using uvec4 = glm::uvec4;
using uint = uint32_t;
using std::abs;
#define SHARED inline
#define PRECISE
#else
#define SHARED
#define PRECISE precise
#endif

// Which triangles of a caster throw its shadow: those that face the light, those that do not, all.
#define CASTS_LIGHT 0u
#define CASTS_BACK 1u
#define CASTS_ALL 2u

// Parts of a volume: its sides; caps of triangles that face the light, and of those that had to be
// turned over.
#define VOLUME_SIDES 0u
#define VOLUME_CAPS 1u
#define VOLUME_TURNED 2u
#define VOLUME_PARTS 3u

// What of caps is drawn. Where near or far plane cuts a caster, its cap at the caster is clipped as
// the surface is, since interpolating from other vertices gives other depths; what lies beyond the
// far plane is drawn by itself, behind everything.
#define CAPS_BOTH 0u    // at the caster and at the far end
#define CAPS_NEAR 1u    // at the caster, between the planes
#define CAPS_BEYOND 2u  // at the caster, beyond the far plane
#define CAPS_FAR 3u     // at the far end

struct VolumeData {
  vec4 row0;      // rows of mesh space -> camera-relative world, as InstanceData has them
  vec4 row1;
  vec4 row2;
  vec4 light;     // w 1: where the mesh's origin is relative to the light; w 0: the way light travels
  vec4 extent;    // xyz: the light relative to the eye; w: where volumes end. To infinity: w of their
                  // far vertices, 0; more before an orthographic eye, whose rays all meet there.
                  // Finite: the distance from the light (directional: from the caster)
  uvec4 first;    // first words of x: edges, y: corners, z: positions
  uvec4 lists;    // first words of the lists of each part; w: of the arguments of their draws
  uvec4 counts;   // x: edges, y: triangles, z: which cast, w: sides that an edge may need, 1 or 2
  uvec4 vertices; // x: of a side, 3 where its far end is one point, else 6; y: of a cap, 3 without
                  // its far end, else 6; z: which caps there are, bit VOLUME_CAPS, VOLUME_TURNED
};

#ifdef __cplusplus
static_assert(offsetof(VolumeData, light) == 48 && offsetof(VolumeData, extent) == 64 &&
              offsetof(VolumeData, first) == 80 && offsetof(VolumeData, lists) == 96 &&
              offsetof(VolumeData, counts) == 112 && offsetof(VolumeData, vertices) == 128 &&
              sizeof(VolumeData) == 144);
#endif

// A difference of positions in mesh space, in the world.
SHARED vec3 throughVolumeRows(VolumeData volume, vec3 v) {
  PRECISE vec3 r;
  r.x = volume.row0.x * v.x + volume.row0.y * v.y + volume.row0.z * v.z;
  r.y = volume.row1.x * v.x + volume.row1.y * v.y + volume.row1.z * v.z;
  r.z = volume.row2.x * v.x + volume.row2.y * v.y + volume.row2.z * v.z;
  return r;
}

// The way light takes past a vertex (position in mesh space), not of unit length: v - L, made of what
// is relative to the light, so that nothing is lost between an eye and a light that are far apart.
SHARED vec3 lightThrough(VolumeData volume, vec3 v) {
  if (volume.light.w == 0.0f) return vec3(volume.light);
  PRECISE vec3 d = throughVolumeRows(volume, v) + vec3(volume.light);
  return d;
}

// How a triangle casts: 1 as it is wound, -1 turned over, 0 not at all. One that lies in a plane with
// the light, as far as floats can tell, has its back to it; of those that all cast it is left out: its
// volume is thinner than rounding.
SHARED int casts(VolumeData volume, vec3 a, vec3 b, vec3 c) {
  PRECISE vec3 u = throughVolumeRows(volume, b - a);
  PRECISE vec3 v = throughVolumeRows(volume, c - a);
  PRECISE vec3 d = lightThrough(volume, a);
  PRECISE vec3 p = vec3(u.y * v.z, u.z * v.x, u.x * v.y);
  PRECISE vec3 q = vec3(u.z * v.y, u.x * v.z, u.y * v.x);
  PRECISE float away = (p.x - q.x) * d.x + (p.y - q.y) * d.y + (p.z - q.z) * d.z;
  PRECISE float size = (abs(p.x) + abs(q.x)) * abs(d.x) + (abs(p.y) + abs(q.y)) * abs(d.y) +
                       (abs(p.z) + abs(q.z)) * abs(d.z);
  // Eight roundings of a sum of six products.
  PRECISE float rounding = size * 4.8e-7f;
  bool front = away < -rounding;
  if (volume.counts.z == CASTS_LIGHT) return front ? 1 : 0;
  if (volume.counts.z == CASTS_BACK) return front ? 0 : -1;
  return front ? 1 : away > rounding ? -1 : 0;
}

#ifdef __cplusplus
#undef SHARED
#undef PRECISE
}  // namespace sb::gpu
#endif

#endif
