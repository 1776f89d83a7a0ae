// Three stochastic depth maps, one a channel (spec 04): layers 3 i to 3 i + 2 of the map are those of
// view i. Without translucent casters there is one, of all channels (decision D3).
#include "common/light_space.glsl"
#include "common/depth_compare.glsl"
layout(constant_id = 22) const bool kColoured = true;

// One exact texel a tap: the receiver's depth there serves all three channels.
vec3 filterExact(LightSample s) {
  int size = textureSize(t_shadowMap, 0).x;
  ivec2 centre = ivec2(floor(s.uvz.xy * float(size)));
  int h = int(kKernel) / 2, first = 3 * int(s.layer);
  vec3 lit = vec3(0);
  float total = 0.0;
  for (int y = -h; y <= h; ++y)
    for (int x = -h; x <= h; ++x) {
      ivec2 texel = centre + ivec2(x, y);
      bool outside = any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(size)));
      float w = kernelWeight(x, y);
      total += w;
      vec3 depths = vec3(-1);
      if (!outside)
        depths = vec3(texelFetch(t_shadowMap, ivec3(texel, first), 0).r,
                      texelFetch(t_shadowMap, ivec3(texel, first + 1), 0).r,
                      texelFetch(t_shadowMap, ivec3(texel, first + 2), 0).r);
      lit += w * vec3(greaterThanEqual(vec3(tapDepth(s, texel)), depths));
    }
  return lit / total;
}

vec3 filterHardwareLayers(LightSample s) {
  vec3 lit;
  s.layer *= 3.0;
  for (int c = 0; c < 3; ++c) {
    lit[c] = filterHardware(s);
    s.layer += 1.0;
  }
  return lit;
}

vec3 lightVisibility(uint light, Receiver r) {
  LightSample s = lightSample(light, r);
  if (!s.inside) return vec3(1);
  if (!kColoured) return vec3(filterMap(s));
  return kHardwareCompare ? filterHardwareLayers(s) : filterExact(s);
}
