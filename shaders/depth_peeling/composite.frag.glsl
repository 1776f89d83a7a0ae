#version 450
// All layers over the opaque picture: colour and transmittance as they stand.
#include "common/shared_slots.h"
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_layers;
layout(location = 0) out vec4 o_color;

void main() { o_color = texelFetch(t_layers, ivec2(gl_FragCoord.xy), 0); }
