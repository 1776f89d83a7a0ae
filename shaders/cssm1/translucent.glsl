// One channel of a translucent caster blocks with probability p = alpha (1 - t): kept or not, then
// the ordinary depth test. The numbers are those of CSSM2.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
#include "common/light_blocking.glsl"
#include "common/caster_depth.glsl"
layout(location = 6) flat in uint v_channel;

void main() {
  storeDepth();
  bvec3 blocked = blockedChannels(0u);
  if (!(v_channel == 0u ? blocked.x : v_channel == 1u ? blocked.y : blocked.z)) discard;
}
