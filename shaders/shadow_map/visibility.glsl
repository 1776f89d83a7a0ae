// Williams' shadow map with percentage-closer filtering (spec 01): manual comparisons, or hardware
// ones, each of which compares four texels first and weights the results bilinearly.
#include "common/light_space.glsl"
layout(constant_id = 19) const bool kHardwareCompare = false;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2DArray t_shadowMap;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 1)) uniform sampler2DArrayShadow t_shadowCompare;

float filterHardware(LightSample s) {
  int h = int(kKernel) / 2;
  // The four texels of a tap lie up to one texel from it on the receiver's plane.
  float bias = s.bias + (abs(s.gradient.x) + abs(s.gradient.y)) * s.texel;
  float lit = 0.0, total = 0.0;
  for (int y = -h; y <= h; ++y)
    for (int x = -h; x <= h; ++x) {
      vec2 offset = vec2(x, y) * s.texel;
      float depth = min(s.uvz.z + dot(s.gradient, offset) - bias, 1.0);
      float w = kernelWeight(x, y);
      total += w;
      lit += w * textureGrad(t_shadowCompare, vec4(s.uvz.xy + offset, s.layer, depth),
                               vec2(0), vec2(0));
    }
  return lit / total;
}

vec3 lightVisibility(uint light, Receiver r) {
  LightSample s = lightSample(light, r);
  if (!s.inside) return vec3(1);
  return vec3(kHardwareCompare ? filterHardware(s) : filterDepth(t_shadowMap, s));
}
