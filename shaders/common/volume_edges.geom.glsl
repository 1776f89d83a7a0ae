#version 450
// Makes the sides that an edge needs, two at most. Caps are left to vertex shaders: drivers need not
// round what a geometry shader says as they round the surfaces that caps coincide with (Mesa's
// software devices divide by w in other code).
#include "common/volume_vertex.glsl"
layout(points) in;
layout(triangle_strip, max_vertices = 12) out;
layout(location = 0) flat in uint v_edge[];
invariant gl_Position;

void main() {
  uint item;
  uint needed = itemsAt(v_edge[0], item), n = verticesOfItem();
  for (uint k = 0u; k < needed; ++k)
    for (uint corner = 0u; corner < n; ++corner) {
      gl_Position = itemVertex(item, corner);
      EmitVertex();
      if (corner % 3u == 2u) EndPrimitive();
    }
}
