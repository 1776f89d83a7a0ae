#version 450
// One triangle over the whole target; instance number for the fragment shader.
layout(location = 0) out vec2 uv;
layout(location = 1) flat out uint instance;
void main() {
  uv = vec2((gl_VertexIndex << 1) & 2, gl_VertexIndex & 2);
  instance = uint(gl_InstanceIndex);
  gl_Position = vec4(uv * 2.0 - 1.0, 0.5, 1.0);
}
