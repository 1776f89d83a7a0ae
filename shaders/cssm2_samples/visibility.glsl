// Coloured stochastic shadow map with several samples a texel; without translucent casters the depth
// map is read in place of the channels.
#include "common/light_space.glsl"
#include "common/sample_filter.glsl"
layout(constant_id = 19) const bool kColoured = true;

vec3 lightVisibility(uint light, Receiver r) {
  LightSample s = lightSample(light, r);
  if (!s.inside) return vec3(1);
  vec3 lit = filterSamples(s);
  return kColoured ? lit : lit.rrr;
}
