#version 450
// A quad (two triangles, 6 vertices) over one cell of a row of cells: the cell's number is the
// vertex's value plus the instance, so that offsets of every kind show in the picture.
layout(location = 0) in uint cell;
layout(binding = 0, std140) uniform Size { uint cells; };
layout(location = 0) flat out uint value;
void main() {
  const vec2 corners[6] = vec2[](vec2(0, 0), vec2(1, 0), vec2(0, 1), vec2(0, 1), vec2(1, 0), vec2(1, 1));
  uint which = cell + uint(gl_InstanceIndex);
  vec2 p = corners[gl_VertexIndex % 6];
  value = which + 1u;
  gl_Position = vec4((float(which) + p.x) / float(cells) * 2.0 - 1.0, p.y * 2.0 - 1.0, 0.0, 1.0);
}
