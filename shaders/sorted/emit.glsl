// Sorted alpha blending: premultiplied, blended by ONE, ONE_MINUS_SRC_ALPHA.
#include "common/opaque_test.glsl"
layout(location = 0) out vec4 o_color;

bool beginFragment(float alpha) {
  if (behindOpaque()) discard;
  return true;
}

void emitFragment(vec3 radiance, float alpha) { o_color = vec4(radiance * alpha, alpha); }
