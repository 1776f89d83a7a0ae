#version 450
// Appends the items of a volume to its lists and counts their vertices as arguments of three draws.
#include "common/volume_mesh.glsl"
layout(local_size_x = 64) in;
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE + 3), std430) writeonly buffer ItemBlock { uint items[]; };
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE + 4), std430) buffer ArgumentBlock { uint arguments[]; };

void append(uint part, uint item) {
  uint n = part == VOLUME_SIDES ? volume.vertices.x : volume.vertices.y;
  uint before = atomicAdd(arguments[volume.lists.w + 4u * part], n);
  items[volume.lists[part] + before / n] = item;
}

void main() {
  uint at = gl_GlobalInvocationID.x + 64u * gl_NumWorkGroups.x * gl_GlobalInvocationID.y;
  if (at < volume.counts.x) {
    int m = sidesOf(edgeAt(at));
    for (int k = 0; k < abs(m); ++k) append(VOLUME_SIDES, 2u * at + (m < 0 ? 1u : 0u));
  }
  if (at < volume.counts.y) {
    int sign = triangleCasts(at);
    if (sign != 0 && (volume.vertices.z >> capPart(sign) & 1u) == 1u) append(capPart(sign), at);
  }
}
