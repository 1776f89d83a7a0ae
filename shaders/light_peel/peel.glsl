// A translucent fragment as peeling from the light sees it. Depth is reversed: 1 near the light.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
#include "common/transform.glsl"
#include "common/light_pass.glsl"
#include "common/receding_depth.glsl"
layout(location = 3) in vec4 v_uv;
layout(location = 4) in vec4 v_color;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2DArray t_opaqueMap;

// Discards what is not there and what lies behind the first opaque surface; what lies in its plane
// does not (the tolerance of techniques/maps/translucent_maps.cpp). Gives what passes.
vec3 peelFragment() {
  float tolerance = 2e-6 * gl_FragCoord.z + fwidth(gl_FragCoord.z) / 32.0;
  ivec3 texel = ivec3(gl_FragCoord.xy, int(shadowViewAt(PASS_SHADOW_VIEW).origin.w));
  OpticsData o = lightOptics(material, v_uv, v_color);
  if (o.alpha < 1.0 / 512.0) discard;
  if (gl_FragCoord.z + tolerance < texelFetch(t_opaqueMap, texel, 0).r) discard;
  return vec3(1) - o.alpha * (vec3(1) - o.t);
}
