#version 450
// The production filter of CSSM2 at given places of a map.
#include "techniques/light_stub.glsl"
#include "cssm2/visibility.glsl"

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= uint(queries.length())) return;
  Query q = queries[i];
  float texel = 1.0 / float(textureSize(t_colourMap, 0).x);
  LightSample s = LightSample(true, q.uvzBias.xyz, q.gradient.xy, q.uvzBias.w, texel, 0.0, 0u, 0.0);
  answers[i] = vec4(filterColour(s), 1);
}
