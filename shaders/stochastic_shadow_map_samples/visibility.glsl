// The same with several samples a texel.
#include "common/light_space.glsl"
#include "common/sample_filter.glsl"

vec3 lightVisibility(uint light, Receiver r) {
  LightSample s = lightSample(light, r);
  return s.inside ? filterSamples(s).rrr : vec3(1);
}
