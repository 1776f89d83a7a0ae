#version 450
// Draws, without colour, where layers are left between the bounds: an occlusion query counts them.
#include "common/shared_slots.h"
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY + 2)) uniform sampler2D t_bounds;
layout(location = 0) out vec4 o_color;

void main() {
  if (texelFetch(t_bounds, ivec2(gl_FragCoord.xy), 0).r < 0.0) discard;
  o_color = vec4(0);
}
