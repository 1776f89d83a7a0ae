#version 450
// A small triangle in the corner at clip x = -1, y = -1; counter-clockwise (y up) for instance 0,
// clockwise in the corner at x = +1, y = +1 for instance 1.
layout(location = 0) flat out uint vertex;
void main() {
  const vec2 corners[3] = vec2[](vec2(0, 0), vec2(1, 0), vec2(0, 1));
  vec2 p = corners[gl_VertexIndex] - 1.0;
  if (gl_InstanceIndex == 1) p = corners[(3 - gl_VertexIndex) % 3];
  vertex = uint(gl_VertexIndex);
  gl_Position = vec4(p, 0.25, 1.0);
}
