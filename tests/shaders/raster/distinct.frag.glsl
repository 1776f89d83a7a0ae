#version 450
layout(location = 0) in vec4 vertexColor;
layout(location = 0) out vec4 color0;
layout(location = 1) out uvec4 color1;
layout(location = 2) out float color2;
void main() {
  color0 = vertexColor;
  color1 = uvec4(gl_FragCoord.xy, 7, 9);
  color2 = vertexColor.r * 8.0;
}
