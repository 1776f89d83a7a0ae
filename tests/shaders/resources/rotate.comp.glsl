#version 450
// target[i] = source[(i + 1) % n] * 2 + 1: every pass of a chain needs all of the one before it.
layout(local_size_x = 64) in;
layout(binding = 8, std430) readonly buffer In { uint source[]; };
layout(binding = 9, std430) buffer Out { uint target[]; };
void main() {
  uint n = uint(source.length()), i = gl_GlobalInvocationID.x;
  target[i] = source[(i + 1u) % n] * 2u + 1u;
}
