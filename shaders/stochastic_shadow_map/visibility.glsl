// Stochastic shadow map (spec 03): a depth map like any other, filtered wider.
#include "common/light_space.glsl"
#include "common/depth_compare.glsl"

vec3 lightVisibility(uint light, Receiver r) {
  LightSample s = lightSample(light, r);
  return s.inside ? vec3(filterMap(s)) : vec3(1);
}
