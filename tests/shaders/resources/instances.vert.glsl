#version 450
// A quad (two triangles, 6 vertices) over one cell of a row of cells, which is an attribute of the
// instance. Vertices carry a corner.
layout(location = 0) in uint corner;
layout(location = 1) in uint cell;
layout(binding = 0, std140) uniform Size { uint cells; };
layout(location = 0) flat out uint value;
void main() {
  const vec2 corners[4] = vec2[](vec2(0, 0), vec2(1, 0), vec2(0, 1), vec2(1, 1));
  vec2 p = corners[corner % 4u];
  value = corner / 4u;
  gl_Position = vec4((float(cell) + p.x) / float(cells) * 2.0 - 1.0, p.y * 2.0 - 1.0, 0.0, 1.0);
}
