#version 450
// Slides a layer under those before it: blended by DST_ALPHA, ONE, for alpha holds the transmittance
// of all layers so far.
#include "common/shared_slots.h"
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_layer;
layout(location = 0) out vec4 o_layers;

void main() {
  vec4 layer = texelFetch(t_layer, ivec2(gl_FragCoord.xy), 0);
  if (layer.a <= 0.0) discard;
  o_layers = layer;
}
