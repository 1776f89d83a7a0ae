#version 450
// Every vertex format at once: point i writes what it received to row i of the results.
layout(location = 0) in float a;
layout(location = 1) in vec2 b;
layout(location = 2) in vec3 c;
layout(location = 3) in vec4 d;
layout(location = 4) in uint e;
layout(location = 5) in uvec2 f;
layout(location = 6) in uvec4 g;
layout(location = 7) in vec4 h;
layout(location = 8) in vec2 perInstance;
layout(location = 0) flat out vec4 floats;
layout(location = 1) flat out uvec4 uints;
layout(location = 2) flat out vec4 colors;
void main() {
  floats = vec4(a, b.x + b.y, c.x + c.y + c.z, d.x + d.y + d.z + d.w);
  uints = uvec4(e, f.x ^ f.y, g.x ^ g.y ^ g.z ^ g.w, uint(gl_VertexIndex));
  colors = h;
  gl_Position = vec4(perInstance, 0.0, 1.0);
  gl_PointSize = 1.0;
}
