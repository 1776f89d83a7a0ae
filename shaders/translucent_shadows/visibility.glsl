// Translucent shadows (spec 02): dark behind the first opaque surface, tinted by all translucent
// casters behind the first of them, white before it.
#include "common/light_space.glsl"
layout(constant_id = 19) const bool kTranslucent = true;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2DArray t_opaqueMap;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 1)) uniform sampler2DArray t_translucentMap;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 2)) uniform sampler2DArray t_colourMap;

vec3 tapColour(LightSample s, ivec2 texel, float depth, uvec4) {
  ivec3 at = ivec3(texel, int(s.layer));
  if (depth >= texelFetch(t_translucentMap, at, 0).r) return vec3(1);
  return texelFetch(t_colourMap, at, 0).rgb;
}
#include "common/coloured_filter.glsl"

vec3 lightVisibility(uint light, Receiver r) {
  LightSample s = lightSample(light, r);
  if (!s.inside) return vec3(1);
  return kTranslucent ? filterOverOpaque(t_opaqueMap, s, uvec4(0))
                      : vec3(filterDepth(t_opaqueMap, s));
}
