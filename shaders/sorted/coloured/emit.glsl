// Sorted blending with a weight per channel: two sources, blended by ONE, SRC1_COLOR.
#define EMITS_WEIGHTS
#include "common/opaque_test.glsl"
layout(location = 0, index = 0) out vec4 o_color;
layout(location = 0, index = 1) out vec4 o_behind;

bool beginFragment(OpticsData optics) {
  if (behindOpaque()) discard;
  return true;
}

void emitFragment(vec3 light, vec3 behind) {
  o_color = vec4(light, 0);
  o_behind = vec4(behind, 1);
}
