#version 450
// basic: the mean of the samples, and the share of them that shows the opaque picture.
// corrected: the mean colour by weight, with the exact opacity of all layers together.
#include "common/shared_slots.h"
layout(constant_id = 33) const bool kBasic = false;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_samples;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY + 1)) uniform sampler2D t_transmittance;
layout(location = 0) out vec4 o_color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = texelFetch(t_samples, pixel, 0);
  if (kBasic) {
    o_color = vec4(sum.rgb, 1.0 - sum.a);
    return;
  }
  // No weight: nothing covers a sample (edges) or no layer at all.
  if (sum.a <= 0.0) discard;
  float through = texelFetch(t_transmittance, pixel, 0).r;
  o_color = vec4((1.0 - through) * sum.rgb / sum.a, through);
}
