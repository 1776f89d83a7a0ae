#version 450
layout(location = 0) out uint color;
void main() { color = uint(gl_FragCoord.y) * 1000u + uint(gl_FragCoord.x); }
