// Lookups into one depth map: manual comparisons, or those of the hardware, which compares four texels
// first and weighs the results bilinearly (spec 01); in a wider filter its taps overlap, and the
// shader does the same with each texel fetched once. Include light_space.glsl before.
layout(constant_id = 19) const bool kHardwareCompare = false;
// The device does not filter this depth format linearly (optional in Vulkan: spec 01, P7): the same
// tap from four fetches.
layout(constant_id = 20) const bool kFetchTaps = false;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2DArray t_shadowMap;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 1)) uniform sampler2DArrayShadow t_shadowCompare;

// Four comparisons weighed bilinearly; texels outside the map are lit.
float compareTap(vec2 uv, float layer, float depth) {
  if (!kFetchTaps)
    return textureGrad(t_shadowCompare, vec4(uv, layer, depth), vec2(0), vec2(0));
  int size = textureSize(t_shadowMap, 0).x;
  precise vec2 at = uv * float(size) - 0.5;
  ivec2 base = ivec2(floor(at));
  vec2 f = at - floor(at);
  float lit[4];
  for (int i = 0; i < 4; ++i) {
    ivec2 texel = base + ivec2(i & 1, i >> 1);
    bool outside = any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(size)));
    bool passes = outside || depth >= texelFetch(t_shadowMap, ivec3(texel, int(layer)), 0).r;
    lit[i] = passes ? 1.0 : 0.0;
  }
  // In this form four equal comparisons give exactly 0 or 1.
  float below = lit[0] + (lit[1] - lit[0]) * f.x, above = lit[2] + (lit[3] - lit[2]) * f.x;
  return below + (above - below) * f.y;
}

// Depth and bias of the tap at a place of the filter: its four texels lie up to one texel from it on
// the receiver's plane.
float hardwareTapDepth(LightSample s, int x, int y) {
  float bias = s.bias + (abs(s.gradient.x) + abs(s.gradient.y)) * s.texel;
  vec2 offset = vec2(x, y) * s.texel;
  precise float depth = s.uvz.z + (s.gradient.x * offset.x + s.gradient.y * offset.y) + bias;
  return max(depth, s.least);
}

// What a tap of the filter adds for one of its texels: its weight, if that is lit.
float litWeight(LightSample s, ivec2 tap, float stored) {
  if (max(abs(tap.x), abs(tap.y)) > int(kKernel) / 2) return 0.0;
  return hardwareTapDepth(s, tap.x, tap.y) >= stored ? kernelWeight(tap.x, tap.y) : 0.0;
}

// The same for the four taps that share a texel: it is the first, second, third and fourth of theirs.
vec4 litWeights(LightSample s, ivec2 texel, ivec2 place, int size, float stored) {
  bool outside = any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(size)));
  if (outside) stored = 0.0;  // depth is reversed: lit
  return vec4(litWeight(s, place, stored), litWeight(s, place - ivec2(1, 0), stored),
              litWeight(s, place - ivec2(0, 1), stored), litWeight(s, place - ivec2(1, 1), stored));
}

// N x N of these taps lie one texel apart: they share (N + 1) x (N + 1) texels, which ((N + 1) / 2)^2
// gathers fetch. Every tap compares its four texels with its own depth, as alone; how many taps
// weigh the lit ones alike is counted first, since the weights within all taps are the same.
float filterOverlapping(LightSample s) {
  int size = textureSize(t_shadowMap, 0).x;
  precise vec2 at = s.uvz.xy * float(size) - 0.5;
  ivec2 base = ivec2(floor(at));
  vec2 f = at - floor(at);
  int h = int(kKernel) / 2;
  vec4 lit = vec4(0);
  for (int y = -h; y <= h; y += 2)
    for (int x = -h; x <= h; x += 2) {
      ivec2 place = ivec2(x, y), texel = base + place;
      vec4 stored = textureGather(t_shadowMap, vec3(vec2(texel + 1) / float(size), s.layer));
      lit += litWeights(s, texel, place, size, stored.w);
      lit += litWeights(s, texel + ivec2(1, 0), place + ivec2(1, 0), size, stored.z);
      lit += litWeights(s, texel + ivec2(0, 1), place + ivec2(0, 1), size, stored.x);
      lit += litWeights(s, texel + ivec2(1, 1), place + ivec2(1, 1), size, stored.y);
    }
  float total = kTent ? float((h + 1) * (h + 1) * (h + 1) * (h + 1)) : float(kKernel * kKernel);
  // In this form a filter that is lit or dark as a whole gives exactly 1 or 0.
  float below = lit.x + (lit.y - lit.x) * f.x, above = lit.z + (lit.w - lit.z) * f.x;
  return (below + (above - below) * f.y) / total;
}

float filterHardware(LightSample s) {
  return kKernel == 1u ? compareTap(s.uvz.xy, s.layer, hardwareTapDepth(s, 0, 0))
                       : filterOverlapping(s);
}

// Share of the filter's taps that are lit.
float filterMap(LightSample s) {
  return kHardwareCompare ? filterHardware(s) : filterDepth(t_shadowMap, s);
}
