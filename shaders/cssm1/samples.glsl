// The same for several samples a texel: each channel keeps a random subset as large as its p, since
// each layer has a coverage of its own. The order of the samples is the surface's.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
#include "common/light_blocking.glsl"
#include "common/sample_subset.glsl"
#include "common/caster_depth.glsl"
layout(constant_id = 18) const uint kSamples = 4u;
layout(location = 6) flat in uint v_channel;

float ofChannel(vec3 v) { return v_channel == 0u ? v.x : v_channel == 1u ? v.y : v.z; }

void main() {
  storeDepth();
  vec4 xi = surfaceNumbers(0u);
  float number = kSharedNumbers ? xi.x : ofChannel(xi.xyz);
  uint kept = sampleSubset(ofChannel(blockingProbability()), kSamples, vec2(number, xi.w));
  if (kept == 0u) discard;
  gl_SampleMask[0] = int(kept);
}
