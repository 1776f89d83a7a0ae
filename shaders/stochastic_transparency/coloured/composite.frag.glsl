#version 450
// basic: the light as it comes, and the share of samples that nothing hides.
// corrected: the light scaled so that what all layers hide is what they hide in truth; in a channel
// in which none hides anything it is right as it is.
#include "common/shared_slots.h"
layout(constant_id = 32) const uint kSamples = 4u;
layout(constant_id = 33) const bool kBasic = false;
#include "stochastic_transparency/coloured/depths.glsl"
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_transmittance;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY + 5)) uniform sampler2D t_light;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY + 6)) uniform sampler2D t_hides;
layout(location = 0, index = 0) out vec4 o_color;
layout(location = 0, index = 1) out vec4 o_behind;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 light = texelFetch(t_light, pixel, 0).rgb;
  vec3 through;
  if (kBasic) {
    through = visibleFrom(-1.0);
  } else {
    through = texelFetch(t_transmittance, pixel, 0).rgb;
    vec3 hides = texelFetch(t_hides, pixel, 0).rgb;
    for (int c = 0; c < 3; ++c)
      if (hides[c] > 0.0) light[c] *= (1.0 - through[c]) / hides[c];
  }
  o_color = vec4(light, 0);
  o_behind = vec4(through, 1);
}
