// Three stochastic depth maps, one a channel (spec 04): layers 3 i to 3 i + 2 of the map are those of
// view i. Without translucent casters there is one, of all channels (decision D3).
#include "common/light_space.glsl"
#include "common/depth_compare.glsl"
layout(constant_id = 22) const bool kColoured = true;

vec3 lightVisibility(uint light, Receiver r) {
  LightSample s = lightSample(light, r);
  if (!s.inside) return vec3(1);
  if (!kColoured) return vec3(filterMap(s));
  vec3 lit;
  s.layer *= 3.0;
  for (int c = 0; c < 3; ++c) {
    lit[c] = filterMap(s);
    s.layer += 1.0;
  }
  return lit;
}
