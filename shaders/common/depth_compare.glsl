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

// N x N of these taps lie one texel apart: they share (N + 1) x (N + 1) texels, which ((N + 1) / 2)^2
// gathers fetch. Every tap compares its four texels with its own depth, as alone; how many taps
// weigh the lit ones alike is counted first, since the weights within all taps are the same.
float filterOverlapping(LightSample s) {
  int size = textureSize(t_shadowMap, 0).x;
  precise vec2 at = s.uvz.xy * float(size) - 0.5;
  ivec2 base = ivec2(floor(at));
  vec2 f = at - floor(at);
  int h = int(kKernel) / 2;
  float lit[4] = float[4](0.0, 0.0, 0.0, 0.0);
  float total = 0.0;
  for (int y = -h; y <= h; y += 2)
    for (int x = -h; x <= h; x += 2) {
      vec4 gathered = textureGather(
          t_shadowMap, vec3(vec2(base + ivec2(x, y) + 1) / float(size), s.layer));
      float stored[4] = float[4](gathered.w, gathered.z, gathered.x, gathered.y);
      for (int i = 0; i < 4; ++i) {
        ivec2 place = ivec2(x + (i & 1), y + (i >> 1)), texel = base + place;
        bool outside = any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(size)));
        // It is the first, second, third and fourth texel of four taps.
        for (int corner = 0; corner < 4; ++corner) {
          ivec2 tap = place - ivec2(corner & 1, corner >> 1);
          if (max(abs(tap.x), abs(tap.y)) > h) continue;
          float w = kernelWeight(tap.x, tap.y);
          if (corner == 0) total += w;
          if (outside || hardwareTapDepth(s, tap.x, tap.y) >= stored[i]) lit[corner] += w;
        }
      }
    }
  // In this form a filter that is lit or dark as a whole gives exactly 1 or 0.
  float below = lit[0] + (lit[1] - lit[0]) * f.x, above = lit[2] + (lit[3] - lit[2]) * f.x;
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
