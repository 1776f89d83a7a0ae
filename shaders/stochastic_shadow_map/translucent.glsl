// A translucent caster is kept with the probability of its opacity; the ordinary depth test does the
// rest, in any order of drawing.
#include "stochastic_shadow_map/blocking.glsl"
#include "common/caster_depth.glsl"

void main() {
  storeDepth();
  if (!noiseBlocks(surfaceNumbers(0u).xxx, vec3(opacity())).x) discard;
}
