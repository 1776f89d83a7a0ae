#version 450
#extension GL_ARB_shader_viewport_layer_array : require
layout(location = 0) in vec4 position;
layout(location = 1) in vec4 color;
layout(location = 0) out vec4 vertexColor;
void main() {
  gl_Position = position;
  gl_Layer = gl_InstanceIndex;
  vertexColor = color * float(gl_InstanceIndex + 1);
}
