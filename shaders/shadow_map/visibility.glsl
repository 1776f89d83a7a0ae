// Williams' shadow map with percentage-closer filtering (spec 01): manual comparisons, or hardware
// ones, each of which compares four texels first and weights the results bilinearly.
#include "common/light_space.glsl"
layout(constant_id = 19) const bool kHardwareCompare = false;
layout(constant_id = 20) const bool kFilterInShader = false;  // the device filters no depth (P7)
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2DArray t_shadowMap;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 1)) uniform sampler2DArrayShadow t_shadowCompare;

// What a linear comparison sampler does: compares at the four nearest texels, then weights.
float compareBilinear(vec2 uv, float layer, float depth) {
  int size = textureSize(t_shadowMap, 0).x;
  vec2 position = uv * float(size) - 0.5;
  ivec2 corner = ivec2(floor(position));
  vec2 f = position - vec2(corner);
  vec4 lit;
  for (int i = 0; i < 4; ++i) {
    ivec2 texel = corner + ivec2(i & 1, i >> 1);
    bool outside = any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(size)));
    lit[i] = outside || depth <= texelFetch(t_shadowMap, ivec3(texel, int(layer)), 0).r ? 1.0 : 0.0;
  }
  return mix(mix(lit.x, lit.y, f.x), mix(lit.z, lit.w, f.x), f.y);
}

float filterHardware(LightSample s) {
  int h = int(kKernel) / 2;
  // The four texels of a tap lie up to one texel from it on the receiver's plane.
  float bias = s.bias + (abs(s.gradient.x) + abs(s.gradient.y)) * s.texel;
  float lit = 0.0, total = 0.0;
  for (int y = -h; y <= h; ++y)
    for (int x = -h; x <= h; ++x) {
      vec2 offset = vec2(x, y) * s.texel;
      precise float depth = s.uvz.z + (s.gradient.x * offset.x + s.gradient.y * offset.y) - bias;
      depth = min(depth, 1.0);
      float w = kernelWeight(x, y);
      total += w;
      lit += w * (kFilterInShader
                      ? compareBilinear(s.uvz.xy + offset, s.layer, depth)
                      : textureGrad(t_shadowCompare, vec4(s.uvz.xy + offset, s.layer, depth),
                                    vec2(0), vec2(0)));
    }
  return lit / total;
}

vec3 lightVisibility(uint light, Receiver r) {
  LightSample s = lightSample(light, r);
  if (!s.inside) return vec3(1);
  return vec3(kHardwareCompare ? filterHardware(s) : filterDepth(t_shadowMap, s));
}
