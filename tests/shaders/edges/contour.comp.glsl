#version 450
// Appends the edges between triangles that face a light and others, and counts them as instances of
// an indirect draw.
#include "common/shared_slots.h"
#include "common/shared_edges.h"
layout(local_size_x = 64) in;
layout(binding = SLOT_UNIFORM(UNIFORM_TECHNIQUE), std140) uniform ParametersBlock {
  vec4 light;
  uvec4 counts;  // x: edges; first words of y: edges, z: corners, w: positions
};
layout(binding = SLOT_STORAGE(6), std430) readonly buffer EdgeBlock { uint edgeWords[]; };
layout(binding = SLOT_STORAGE(7), std430) readonly buffer CornerBlock { uint corners[]; };
layout(binding = SLOT_STORAGE(8), std430) readonly buffer PositionBlock { float positions[]; };
layout(binding = SLOT_STORAGE(9), std430) buffer AppendedBlock { uint appended[]; };
layout(binding = SLOT_STORAGE(10), std430) buffer ArgumentBlock { uint arguments[]; };

vec3 positionOf(uint vertex) {
  uint at = counts.w + 3u * vertex;
  return vec3(positions[at], positions[at + 1u], positions[at + 2u]);
}

int casts(uint side) {
  if (side == NO_TRIANGLE) return 0;
  uint at = counts.z + 3u * edgeTriangle(side);
  vec3 a = positionOf(corners[at]), b = positionOf(corners[at + 1u]), c = positionOf(corners[at + 2u]);
  return dot(cross(b - a, c - a), light.xyz - light.w * a) > 0.0 ? 1 : 0;
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= counts.x) return;
  uint at = counts.y + 4u * i;
  EdgeData edge = EdgeData(uvec4(edgeWords[at], edgeWords[at + 1u], edgeWords[at + 2u], edgeWords[at + 3u]));
  int m = edgeMultiplicity(edge, casts(edge.ends.z), casts(edge.ends.w));
  if (m == 0) return;
  appended[atomicAdd(arguments[1], 1u)] = i;
}
