// The same for several samples a texel: a random subset of them is kept. Its numbers belong to the
// surface, so that the subsets of two layers are independent; alpha to coverage nests them (spec 03).
#include "stochastic_shadow_map/blocking.glsl"
#include "common/sample_subset.glsl"
#include "common/caster_depth.glsl"
layout(constant_id = 18) const uint kSamples = 4u;

void main() {
  storeDepth();
  uint kept = sampleSubset(opacity(), kSamples, surfaceNumbers(0u).xy);
  if (kept == 0u) discard;
  gl_SampleMask[0] = int(kept);
}
