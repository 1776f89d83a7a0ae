#version 450
layout(location = 0) flat in vec4 floats;
layout(location = 1) flat in uvec4 uints;
layout(location = 2) flat in vec4 colors;
layout(location = 0) out vec4 outFloats;
layout(location = 1) out uvec4 outUints;
layout(location = 2) out vec4 outColors;
void main() {
  outFloats = floats;
  outUints = uints;
  outColors = colors;
}
