#version 450
// at.xyz: coordinates, at.w: level of detail or depth reference.
layout(local_size_x = 1) in;
layout(binding = 24) uniform sampler2D tex;
layout(binding = 8, std430) readonly buffer In { vec4 at[]; };
layout(binding = 9, std430) buffer Out { vec4 value[]; };
void main() {
  uint i = gl_GlobalInvocationID.x;
  vec4 a = at[i];
  value[i] = vec4(textureSize(tex, int(a.w)), textureQueryLevels(tex), 0);
}
