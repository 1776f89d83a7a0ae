#version 450
// Sides at every edge and caps at every triangle, without area where none is needed (the degenerate
// quads of spec 07).
#include "common/volume_vertex.glsl"
invariant gl_Position;

void main() {
  uint vertex = uint(gl_VertexIndex), n = verticesOfItem();
  uint copies = kPart == VOLUME_SIDES ? volume.counts.w : 1u, item;
  uint needed = itemsAt(vertex / (n * copies), item);
  bool exists = (vertex / n) % copies < needed;
  gl_Position = exists ? itemVertex(item, vertex % n) : vec4(2, 2, 2, 1);
}
