// The layers at the near and at the far bound, each with its light (ADD) and its weight of what lies
// behind (multiplied): where two fragments share a depth, weights are right and light of the hinder
// one is not dimmed.
#define EMITS_WEIGHTS
#include "dual_depth_peeling/bounds.glsl"
layout(location = 1) out vec4 o_front;
layout(location = 2) out vec4 o_frontBehind;
layout(location = 3) out vec4 o_back;
layout(location = 4) out vec4 o_backBehind;

bool beginFragment(OpticsData optics) {
  o_front = vec4(0);
  o_back = vec4(0);
  o_frontBehind = vec4(1);
  o_backBehind = vec4(1);
  return atBound();
}

void emitFragment(vec3 light, vec3 behind) {
  if (g_isFront) {
    o_front = vec4(light, 0);
    o_frontBehind = vec4(behind, 1);
  } else {
    o_back = vec4(light, 0);
    o_backBehind = vec4(behind, 1);
  }
}
