#version 450
// The production random numbers as bits.
#include "common/shared_hash.h"
layout(binding = 8, std430) readonly buffer Inputs { uvec4 inputs[]; };
layout(binding = 9, std430) writeonly buffer Outputs { uvec4 outputs[]; };
layout(local_size_x = 64) in;

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= uint(inputs.length())) return;
  uvec4 v = inputs[i];
  uint key = surfaceKey(v.z, v.w, v.x);
  outputs[i] = floatBitsToUint(randomNumbers(v.x, v.y, key, v.z & 3u, v.w));
}
