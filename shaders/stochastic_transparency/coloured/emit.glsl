// Each fragment adds its light, and what it hides of each channel, weighted by the share of samples
// in which nothing nearer hides it; its own samples count.
#define EMITS_WEIGHTS
#include "common/layer_depth.glsl"
#include "stochastic_transparency/subset.glsl"
#include "stochastic_transparency/coloured/depths.glsl"
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_opaqueDepth;
layout(location = 0) out vec4 o_light;
layout(location = 1) out vec4 o_hides;

bool beginFragment(OpticsData optics) {
  if (hiddenBy(texelFetch(t_opaqueDepth, ivec2(gl_FragCoord.xy), 0).r, layerDepth())) discard;
  return true;
}

void emitFragment(vec3 light, vec3 behind) {
  vec3 visible = visibleFrom(layerDepth());
  o_light = vec4(light * visible, 0);
  o_hides = vec4((1.0 - behind) * visible, 0);
}
