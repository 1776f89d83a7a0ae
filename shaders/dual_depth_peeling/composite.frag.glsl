#version 450
// Front layers over back layers over the picture; alpha of both is a transmittance.
#include "common/shared_slots.h"
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_front;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY + 1)) uniform sampler2D t_back;
layout(location = 0) out vec4 o_color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 front = texelFetch(t_front, pixel, 0), back = texelFetch(t_back, pixel, 0);
  o_color = vec4(front.rgb + front.a * back.rgb, front.a * back.a);
}
