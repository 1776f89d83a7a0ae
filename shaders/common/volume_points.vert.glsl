#version 450
// A point for each edge or triangle, for the geometry shader.
layout(location = 0) flat out uint v_at;

void main() {
  v_at = uint(gl_VertexIndex);
  gl_Position = vec4(0, 0, 0, 1);
}
