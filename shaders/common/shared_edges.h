// Edges of meshes, as C++ fills them and GLSL reads them.
#ifndef SHADOWBENCH_SHARED_EDGES_H
#define SHADOWBENCH_SHARED_EDGES_H

#ifdef __cplusplus
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
namespace sb::gpu {
using uvec4 = glm::uvec4;
#endif

// No triangle on that side of an edge.
#define NO_TRIANGLE 0xFFFFFFFFu

// An edge with the triangles on its sides; where more than two meet, several stand for one edge.
struct EdgeData {
  uvec4 ends;  // x, y: vertices of the mesh, from low to high: the edge's own direction; z, w:
               // triangles of the mesh, each 2 t + 1 if it goes from low to high, 2 t if back
};

#ifdef __cplusplus
static_assert(sizeof(EdgeData) == 16);
}  // namespace sb::gpu
#else
// How often, and which way, the sides of a volume are needed along an edge (spec 07): `a`, `b` say
// how its triangles cast, 1 as they are wound, -1 turned over, 0 not at all.
int edgeMultiplicity(EdgeData edge, int a, int b) {
  int m = (edge.ends.z & 1u) == 1u ? a : -a;
  if (edge.ends.w == NO_TRIANGLE) return m;
  return m + ((edge.ends.w & 1u) == 1u ? b : -b);
}
uint edgeTriangle(uint side) { return side >> 1; }
#endif

#endif
