#version 450
// Light of one layer or of many over the picture, which their weights let through by channel: two
// sources, blended by ONE, SRC1_COLOR.
#include "common/shared_slots.h"
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_light;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY + 1)) uniform sampler2D t_behind;
layout(location = 0, index = 0) out vec4 o_color;
layout(location = 0, index = 1) out vec4 o_behind;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  o_color = vec4(texelFetch(t_light, pixel, 0).rgb, 0);
  o_behind = vec4(texelFetch(t_behind, pixel, 0).rgb, 1);
}
