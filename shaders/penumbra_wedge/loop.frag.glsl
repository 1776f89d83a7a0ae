#version 450
// What one loop hides: in the penumbra the light's centre is hidden where it lies outside none of
// the edges that cross the light; elsewhere where the loop's volume says so.
#include "common/shared_slots.h"
layout(location = 0) out vec4 o_hidden;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2D loopShares;

void main() {
  vec4 loop = texelFetch(loopShares, ivec2(gl_FragCoord.xy), 0);
  float centre = loop.b == 0.0 ? loop.r : loop.g == 0.0 ? 1.0 : 0.0;
  o_hidden = vec4(clamp(centre + loop.a, 0.0, 1.0));
}
