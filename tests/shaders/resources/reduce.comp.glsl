#version 450
// Sum of 64 values through shared memory.
layout(local_size_x = 64) in;
layout(binding = 8, std430) readonly buffer In { uint values[]; };
layout(binding = 9, std430) buffer Out { uint sums[]; };
shared uint partial[64];
void main() {
  uint i = gl_LocalInvocationID.x;
  partial[i] = values[gl_GlobalInvocationID.x];
  barrier();
  for (uint step = 32u; step > 0u; step >>= 1u) {
    if (i < step) partial[i] += partial[i + step];
    barrier();
  }
  if (i == 0u) sums[gl_WorkGroupID.x] = partial[0];
}
