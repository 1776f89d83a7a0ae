// A translucent caster in a stochastic map: which channels of the texel at hand it blocks. Each is
// one experiment, of probability p = alpha (1 - t) (spec 04). Include material.glsl before.
#include "common/shared_hash.h"
#include "common/instance_ids.glsl"
#include "common/transform.glsl"
#include "common/light_pass.glsl"
#include "common/noise.glsl"
layout(constant_id = 16) const bool kSharedNumbers = false;  // one number for all channels
// Shaders that run once a sample say `sample in`: left to the device, attributes differ between APIs.
#ifndef LIGHT_INPUT
#define LIGHT_INPUT in
#endif
layout(location = 3) LIGHT_INPUT vec4 v_uv;
layout(location = 4) LIGHT_INPUT vec4 v_color;

vec3 blockingProbability() {
  OpticsData optics = lightOptics(material, v_uv, v_color);
  return optics.alpha * (vec3(1) - optics.t);
}

// Of the surface at hand; its key is persistent (decision D2).
vec4 surfaceNumbers(uint sampleIndex) {
  uint triangle = floatBitsToUint(triangles[INSTANCE_FIRST_TRIANGLE + uint(gl_PrimitiveID)].normalKey.w);
  return noiseNumbers(surfaceKey(INSTANCE_MESH_KEY, INSTANCE_KEY, triangle), sampleIndex, v_uv.xy);
}

bvec3 blockedChannels(uint sampleIndex) {
  vec4 xi = surfaceNumbers(sampleIndex);
  return noiseBlocks(kSharedNumbers ? xi.xxx : xi.xyz, blockingProbability());
}
