#version 450
// Where floats count a volume: no light.
#include "common/shared_slots.h"
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2D counts;
layout(location = 0) out vec4 o_light;

void main() {
  if (texelFetch(counts, ivec2(gl_FragCoord.xy), 0).r == 0.0) discard;
  o_light = vec4(0);
}
