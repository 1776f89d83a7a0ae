#version 450
// 1 where a surface of the layer is.
#include "common/shared_slots.h"
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 1)) uniform sampler2D t_depth;
layout(location = 0) out vec4 o_answer;

void main() {
  o_answer = vec4(texelFetch(t_depth, ivec2(gl_FragCoord.xy), 0).r > 0.0 ? 1.0 : 0.0);
}
