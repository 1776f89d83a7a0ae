#version 450
layout(location = 0) in vec4 vertexColor;
layout(location = 0, index = 0) out vec4 color;
layout(location = 0, index = 1) out vec4 factor;
void main() {
  color = vertexColor;
  factor = vec4(0.5, 0.25, 1.0, 0.0);
}
