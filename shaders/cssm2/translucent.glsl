// Pass B: each channel of a translucent caster blocks with probability p = alpha (1 - t). Blended
// by MAX of the reversed depth, so that the blocker nearest to the light remains in each channel, in
// any order of drawing.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
#include "common/light_blocking.glsl"
#include "common/receding_depth.glsl"
layout(location = 0) out vec4 o_depths;

void writeDepths(uint sampleIndex) {
  float depth = recedingDepth();
  bvec3 blocked = blockedChannels(sampleIndex);
  if (!any(blocked)) discard;
  o_depths = vec4(mix(vec3(0), vec3(depth), vec3(blocked)), 1);
}
