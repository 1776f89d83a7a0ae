#version 450
// Layers of translucent surfaces at each texel, by addition.
#include "light_peel/peel.glsl"
layout(location = 0) out vec4 o_count;

void main() {
  peelFragment();
  o_count = vec4(1);
}
