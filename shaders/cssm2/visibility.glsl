// Coloured stochastic shadow map (spec 04): three depths a texel, three comparisons a fetch. The
// opaque depth is in every channel; without translucent casters the channels do not exist and the
// depth map itself is read (decision D3).
#include "common/light_space.glsl"
layout(constant_id = 19) const bool kColoured = true;
// Wide only where 3 x 3 texels disagree. Where chance makes all nine alike they are believed: biased
// toward the more likely of lit and blocked (techniques/methods/shadow/cssm2.cpp).
layout(constant_id = 22) const bool kAdaptive = false;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2DArray t_depthMap;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 1)) uniform sampler2DArray t_colourMap;

// Share of lit taps in each channel, `h` texels around the receiver; outside the map is lit.
vec3 filterWithin(LightSample s, int h) {
  int size = textureSize(t_colourMap, 0).x;
  ivec2 centre = ivec2(floor(s.uvz.xy * float(size)));
  vec3 lit = vec3(0);
  float total = 0.0;
  for (int y = -h; y <= h; ++y)
    for (int x = -h; x <= h; ++x) {
      ivec2 texel = centre + ivec2(x, y);
      bool outside = any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(size)));
      float w = kernelWeight(x, y);
      total += w;
      vec3 depths = outside ? vec3(-1) : texelFetch(t_colourMap, ivec3(texel, int(s.layer)), 0).rgb;
      lit += w * vec3(greaterThanEqual(vec3(tapDepth(s, texel)), depths));
    }
  return lit / total;
}

vec3 filterColour(LightSample s) {
  int h = int(kKernel) / 2;
  if (kAdaptive && h > 1) {
    vec3 near = filterWithin(s, 1);
    if (!any(notEqual(near, floor(near)))) return near;
  }
  return filterWithin(s, h);
}

vec3 lightVisibility(uint light, Receiver r) {
  LightSample s = lightSample(light, r);
  if (!s.inside) return vec3(1);
  return kColoured ? filterColour(s) : vec3(filterDepth(t_depthMap, s));
}
