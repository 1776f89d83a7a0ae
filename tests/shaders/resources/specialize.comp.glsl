#version 450
layout(local_size_x_id = 4, local_size_y = 1, local_size_z = 1) in;
layout(constant_id = 0) const bool kFlag = false;
layout(constant_id = 1) const int kInt = 1;
layout(constant_id = 2) const uint kUint = 2u;
layout(constant_id = 3) const float kFloat = 0.5;
layout(constant_id = 5) const uint kLength = 4u;
layout(binding = 8, std430) buffer Out { uint values[]; };
void main() {
  uint squares[kLength];
  for (uint i = 0u; i < kLength; ++i) squares[i] = i * i;
  atomicAdd(values[0], 1u);
  if (gl_LocalInvocationID.x != 0u) return;
  values[1] = kFlag ? 1u : 0u;
  values[2] = uint(kInt);
  values[3] = kUint;
  values[4] = floatBitsToUint(kFloat);
  values[5] = gl_WorkGroupSize.x;
  values[6] = squares[kLength - 1u];
}
