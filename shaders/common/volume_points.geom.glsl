#version 450
// Makes the sides of an edge or the caps of a triangle.
#include "common/volume_vertex.glsl"
layout(points) in;
layout(triangle_strip, max_vertices = 12) out;
layout(location = 0) flat in uint v_at[];
invariant gl_Position;

void main() {
  uint item;
  uint needed = itemsAt(v_at[0], item), n = verticesOfItem();
  for (uint k = 0u; k < needed; ++k)
    for (uint corner = 0u; corner < n; ++corner) {
      gl_Position = itemVertex(item, corner);
      EmitVertex();
      if (corner % 3u == 2u) EndPrimitive();
    }
}
