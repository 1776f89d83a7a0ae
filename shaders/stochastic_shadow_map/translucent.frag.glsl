#version 450
// A translucent caster is kept with the probability of its opacity; the ordinary depth test does the
// rest, in any order of drawing.
#include "stochastic_shadow_map/blocking.glsl"

void main() {
  if (!noiseBlocks(surfaceNumbers(0u).xxx, vec3(opacity())).x) discard;
}
