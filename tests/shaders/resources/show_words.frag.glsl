#version 450
layout(binding = 8, std430) readonly buffer In { uint source[]; };
layout(binding = 0, std140) uniform Size { uint width; };
layout(location = 0) out uint color;
void main() { color = source[uint(gl_FragCoord.y) * width + uint(gl_FragCoord.x)]; }
