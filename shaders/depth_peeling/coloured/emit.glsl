// One layer, as without colours; its weight of what lies behind goes to a second target.
#define EMITS_WEIGHTS
#include "depth_peeling/peel.glsl"
layout(location = 0) out vec4 o_light;
layout(location = 1) out vec4 o_behind;

bool beginFragment(OpticsData optics) {
  discardUnlessNext();
  return true;
}

void emitFragment(vec3 light, vec3 behind) {
  o_light = vec4(light, 1);
  o_behind = vec4(behind, 1);
}
