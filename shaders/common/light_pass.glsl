#ifndef LIGHT_PASS_GLSL
#define LIGHT_PASS_GLSL
#include "common/transform.glsl"
// The view that a light pass renders: parameters of the pass.
layout(binding = SLOT_UNIFORM(UNIFORM_PASS), std140) uniform PassBlock { uvec4 passIds; };

#define PASS_SHADOW_VIEW passIds.x

vec4 toLightClip(vec3 relative) {
  ShadowViewData view = shadowViewAt(PASS_SHADOW_VIEW);
  precise vec3 p = relative - view.origin.xyz;
  return toClip(view.toClip, p);
}
#endif
