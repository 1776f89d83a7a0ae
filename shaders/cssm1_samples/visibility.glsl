// Three stochastic depth maps of several samples a texel, one map a channel; one of all channels
// without translucent casters.
#include "common/light_space.glsl"
#include "common/sample_filter.glsl"
layout(constant_id = 22) const bool kColoured = true;

vec3 lightVisibility(uint light, Receiver r) {
  LightSample s = lightSample(light, r);
  if (!s.inside) return vec3(1);
  if (!kColoured) return filterSamples(s).rrr;
  vec3 lit;
  s.layer *= 3.0;
  for (int c = 0; c < 3; ++c) {
    lit[c] = filterSamples(s).r;
    s.layer += 1.0;
  }
  return lit;
}
