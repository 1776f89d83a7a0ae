#version 450
// Pass B: each channel of a translucent caster blocks with probability p = alpha (1 - t). Blended
// by MAX of the reversed depth, so that the blocker nearest to the light remains in each channel, in
// any order of drawing.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
#include "common/shared_hash.h"
#include "common/transform.glsl"
#include "common/light_pass.glsl"
layout(constant_id = 16) const bool kSharedNumbers = false;  // one number for all channels
layout(location = 3) in vec4 v_uv;
layout(location = 4) in vec4 v_color;
layout(location = 0) out vec4 o_depths;

void main() {
  InstanceData i = instances[draw.ids.x];
  OpticsData optics = lightOptics(materials[i.ids.x], v_uv, v_color);
  vec3 blocking = optics.alpha * (vec3(1) - optics.t);
  uint triangle = floatBitsToUint(triangles[i.ids.z + uint(gl_PrimitiveID)].normalKey.w);
  uvec2 texel = uvec2(gl_FragCoord.xy);
  vec4 xi = randomNumbers(texel.x, texel.y, surfaceKey(i.ids.w, i.ids.y, triangle),
                          0u, pcg4d(uvec4(frame.counts.w, shadowViews[PASS_SHADOW_VIEW].ids.x, 0u, 0u)).x);
  vec3 number = kSharedNumbers ? xi.xxx : xi.xyz;
  bvec3 blocked = lessThan(number, blocking);
  if (!any(blocked)) discard;
  o_depths = vec4(mix(vec3(0), gl_FragCoord.zzz, vec3(blocked)), 1);
}
