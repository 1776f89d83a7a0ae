#version 450
// One triangle that covers the target; no vertex buffer.
void main() {
  vec2 p = vec2((gl_VertexIndex & 1) * 4 - 1, (gl_VertexIndex >> 1) * 4 - 1);
  gl_Position = vec4(p, 0, 1);
}
