// One layer: the nearest of the fragments that may be the next one.
#include "depth_peeling/peel.glsl"
layout(location = 0) out vec4 o_layer;

bool beginFragment(float alpha) {
  discardUnlessNext();
  return true;
}

void emitFragment(vec3 radiance, float alpha) { o_layer = vec4(radiance * alpha, alpha); }
