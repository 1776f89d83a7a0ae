#version 450
// Density, lattice and phase function of media as shaders compute them.
#include "common/shared_slots.h"
#include "common/shared_hash.h"
#include "common/shared_medium.h"
layout(binding = SLOT_UNIFORM(UNIFORM_MEDIA), std140) uniform Media { MediaBlock block; };
layout(binding = 8, std430) readonly buffer Inputs { vec4 inputs[]; };  // place; cosine
layout(binding = 9, std430) writeonly buffer Outputs { vec4 outputs[]; };
layout(local_size_x = 64) in;

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= uint(inputs.length())) return;
  MediumData m = block.media[i % block.count.x];
  vec4 p = vec4(inputs[i].xyz, 1.0);
  vec3 q = vec3(dot(m.toBox0, p), dot(m.toBox1, p), dot(m.toBox2, p));
  SmokeShape smoke = SmokeShape(m.smoke.x, m.smoke.y, m.ids.z, m.ids.y);
  outputs[i] = vec4(smokeDensity(smoke, q), latticeValue(uvec3(i, i * 7u, ~i), m.ids.y),
                    henyeyGreenstein(m.extinction.w, inputs[i].w), sinTurns(p.x));
}
