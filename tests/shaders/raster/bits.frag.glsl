#version 450
layout(location = 0) in vec4 vertexColor;
layout(location = 0) out uvec4 bits;
void main() { bits = uvec4(vertexColor); }
