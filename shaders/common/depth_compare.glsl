// Lookups into one depth map: manual comparisons, or hardware ones, each of which compares four texels
// first and weighs the results bilinearly (spec 01). Include light_space.glsl before.
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

float filterHardware(LightSample s) {
  int h = int(kKernel) / 2;
  // The four texels of a tap lie up to one texel from it on the receiver's plane.
  float bias = s.bias + (abs(s.gradient.x) + abs(s.gradient.y)) * s.texel;
  float lit = 0.0, total = 0.0;
  for (int y = -h; y <= h; ++y)
    for (int x = -h; x <= h; ++x) {
      vec2 offset = vec2(x, y) * s.texel;
      precise float depth = s.uvz.z + (s.gradient.x * offset.x + s.gradient.y * offset.y) + bias;
      depth = max(depth, s.least);
      float w = kernelWeight(x, y);
      total += w;
      lit += w * compareTap(s.uvz.xy + offset, s.layer, depth);
    }
  return lit / total;
}

// Share of the filter's taps that are lit.
float filterMap(LightSample s) {
  return kHardwareCompare ? filterHardware(s) : filterDepth(t_shadowMap, s);
}
