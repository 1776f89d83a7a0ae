#version 450
// Which mesh, and which of its triangles, covers a pixel.
layout(location = 0) flat in uint value;
layout(location = 0) out uint color;
void main() { color = 10u * value + uint(gl_PrimitiveID) + 1u; }
