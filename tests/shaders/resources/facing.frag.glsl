#version 450
// red: row, green: column, blue: facing (1 front, 2 back), alpha: provoking vertex.
layout(location = 0) flat in uint vertex;
layout(location = 0) out uvec4 color;
void main() {
  color = uvec4(uvec2(gl_FragCoord.yx), gl_FrontFacing ? 1u : 2u, vertex + 10u);
}
