#version 450
// Where the stencil counts a volume: no light.
layout(location = 0) out vec4 o_light;
void main() { o_light = vec4(0); }
