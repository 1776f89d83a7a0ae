// The fragment at the near bound goes under the front layers, the one at the far bound over the back
// layers.
#include "dual_depth_peeling/bounds.glsl"
layout(location = 1) out vec4 o_front;
layout(location = 2) out vec4 o_back;

bool beginFragment(float alpha) {
  // What is not written below leaves both sides as they are: colour 0, opacity 0.
  o_front = vec4(0);
  o_back = vec4(0);
  return atBound();
}

void emitFragment(vec3 radiance, float alpha) {
  vec4 color = vec4(radiance * alpha, alpha);
  if (g_isFront)
    o_front = color;
  else
    o_back = color;
}
