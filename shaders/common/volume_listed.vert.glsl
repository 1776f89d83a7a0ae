#version 450
// Items of a list that the CPU or a compute shader has written.
#include "common/volume_vertex.glsl"
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE + 3), std430) readonly buffer ItemBlock { uint items[]; };
invariant gl_Position;

void main() {
  uint vertex = uint(gl_VertexIndex), n = verticesOfItem();
  gl_Position = itemVertex(items[volume.lists[kPart] + vertex / n], vertex % n);
}
