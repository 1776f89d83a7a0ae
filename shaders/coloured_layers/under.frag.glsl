#version 450
// Slides a layer under those before it, with a transmittance per channel. Both targets add (ONE,
// ONE): colour to what is there, the next transmittance to a cleared target.
#include "common/shared_slots.h"
layout(constant_id = 32) const bool kFirstLayer = false;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_light;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY + 1)) uniform sampler2D t_behind;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY + 2)) uniform sampler2D t_through;
layout(location = 0) out vec4 o_color;
layout(location = 1) out vec4 o_through;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 through = kFirstLayer ? vec3(1) : texelFetch(t_through, pixel, 0).rgb;
  o_color = vec4(through * texelFetch(t_light, pixel, 0).rgb, 0);
  o_through = vec4(through * texelFetch(t_behind, pixel, 0).rgb, 0);
}
