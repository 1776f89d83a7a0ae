#version 450
layout(binding = 0, std140) uniform Color { vec4 value; };
layout(location = 0) out vec4 color;
void main() { color = value; }
