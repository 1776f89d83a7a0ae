#version 450
layout(local_size_x = 8) in;
layout(binding = 8, std430) buffer Out { uint values[]; };
void main() { values[gl_GlobalInvocationID.x] = gl_GlobalInvocationID.x * 3u + 1u; }
