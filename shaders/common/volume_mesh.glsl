// The caster of a shadow volume: its edges and triangles, and which of them cast.
#include "common/shared_slots.h"
#include "common/shared_edges.h"
#include "common/shared_volume.h"

layout(binding = SLOT_UNIFORM(UNIFORM_TECHNIQUE), std140) uniform VolumeBlock { VolumeData volume; };
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE), std430) readonly buffer EdgeBlock {
  uint edgeWords[];
};
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE + 1), std430) readonly buffer CornerBlock {
  uint corners[];
};
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE + 2), std430) readonly buffer PositionBlock {
  float positions[];
};

EdgeData edgeAt(uint edge) {
  uint at = volume.first.x + 4u * edge;
  return EdgeData(
      uvec4(edgeWords[at], edgeWords[at + 1u], edgeWords[at + 2u], edgeWords[at + 3u]));
}

uint cornerAt(uint triangle, uint corner) { return corners[volume.first.y + 3u * triangle + corner]; }

// In mesh space.
vec3 positionOf(uint vertex) {
  uint at = volume.first.z + 3u * vertex;
  return vec3(positions[at], positions[at + 1u], positions[at + 2u]);
}

int triangleCasts(uint triangle) {
  return casts(volume, positionOf(cornerAt(triangle, 0u)), positionOf(cornerAt(triangle, 1u)),
               positionOf(cornerAt(triangle, 2u)));
}

// Signed number of sides along an edge.
int sidesOf(EdgeData edge) {
  int a = triangleCasts(edgeTriangle(edge.ends.z));
  int b = edge.ends.w == NO_TRIANGLE ? 0 : triangleCasts(edgeTriangle(edge.ends.w));
  return edgeMultiplicity(edge, a, b);
}

// Caps of a triangle that casts as `sign` says are that part of the volume.
uint capPart(int sign) { return sign > 0 ? VOLUME_CAPS : VOLUME_TURNED; }
