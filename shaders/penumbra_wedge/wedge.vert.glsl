#version 450
// Hulls of penumbrae, one draw for all of a light.
#include "penumbra_wedge/wedges.glsl"
layout(location = 0) flat out uint v_wedge;

void main() {
  uint vertex = uint(gl_VertexIndex) % WEDGE_VERTICES;
  v_wedge = uint(gl_VertexIndex) / WEDGE_VERTICES;
  WedgeData w = wedges[v_wedge];
  vec4 corner = w.hull[wedgeCorner(vertex)];
  gl_Position = frame.viewProjection * corner;
  // All that is seen: one triangle, of which the back is seen.
  if (w.end.w != 0.0)
    gl_Position = vertex < 3u ? vec4(4.0 * vec2(vertex >> 1, vertex & 1u) - 1.0, 0, 1)
                              : vec4(2, 2, 2, 1);
}
