#version 450
// The production filters of ShadowMap at given places of a map.
#include "techniques/light_stub.glsl"
#include "shadow_map/visibility.glsl"

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= uint(queries.length())) return;
  Query q = queries[i];
  float texel = 1.0 / float(textureSize(t_shadowMap, 0).x);
  LightSample s = LightSample(true, q.uvzBias.xyz, q.gradient.xy, q.uvzBias.w, texel, 0.0, 0u, 0.0);
  answers[i] = vec4(kHardwareCompare ? filterHardware(s) : filterDepth(t_shadowMap, s));
}
