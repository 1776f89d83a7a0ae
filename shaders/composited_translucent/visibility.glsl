// Composited translucent shadows (spec 05): every receiver reads the colour behind the translucent
// casters that lie before it. Which layer of which map that is stands in a table by view and
// instance.
#include "common/light_space.glsl"
layout(constant_id = 19) const bool kTranslucent = true;
layout(constant_id = 20) const bool kPeeled = false;       // some casters have peeled layers
layout(constant_id = 21) const bool kNearestDepth = false; // lit before the nearest caster of the map
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2DArray t_opaqueMap;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 1)) uniform sampler2DArray t_colourMap;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 2)) uniform sampler2DArray t_translucentMap;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 3)) uniform sampler2DArray t_peeledDepth;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 4)) uniform sampler2DArray t_peeledColour;
// x: 1 + layer of the colour map, 0: white; y: first peeled layer; z: number of them. The first
// entry's x is the number of instances; those of a view follow one another.
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE), std430) readonly buffer ReceiverBlock {
  uvec4 receivers[];
};

vec3 tapColour(LightSample s, ivec2 texel, float depth, uvec4 layers) {
  if (kNearestDepth && depth >= texelFetch(t_translucentMap, ivec3(texel, int(s.layer)), 0).r)
    return vec3(1);
  vec3 colour = vec3(1);
  if (layers.x > 0u)
    colour = texelFetch(t_colourMap, ivec3(texel, int(layers.x) - 1), 0).rgb;
  if (kPeeled) {
    int before = 0;
    while (before < int(layers.z) &&
           depth < texelFetch(t_peeledDepth, ivec3(texel, int(layers.y) + before), 0).r)
      ++before;
    if (before > 0)
      colour *= texelFetch(t_peeledColour, ivec3(texel, int(layers.y) + before - 1), 0).rgb;
  }
  return colour;
}
#include "common/coloured_filter.glsl"

vec3 lightVisibility(uint light, Receiver r) {
  LightSample s = lightSample(light, r);
  if (!s.inside) return vec3(1);
  if (!kTranslucent) return vec3(filterDepth(t_opaqueMap, s));
  return filterOverOpaque(t_opaqueMap, s, receivers[1u + s.view * receivers[0].x + r.instance]);
}
