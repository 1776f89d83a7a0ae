#version 450
// A point for each edge, for the geometry shader.
layout(location = 0) flat out uint v_edge;

void main() {
  v_edge = uint(gl_VertexIndex);
  gl_Position = vec4(0, 0, 0, 1);
}
