#version 450
// Copies words between buffers; makes arguments, indices, vertices and uniforms on the GPU.
layout(local_size_x = 1) in;
layout(binding = 8, std430) readonly buffer In { uint source[]; };
layout(binding = 9, std430) buffer Out { uint target[]; };
void main() { target[gl_GlobalInvocationID.x] = source[gl_GlobalInvocationID.x]; }
