#version 450
// Stochastic depths by channel (RGB) and sample (target): the nearest fragment that keeps the sample
// in that channel, by MAX blending. A fragment keeps as large a share of samples as it hides of a
// channel, and the same numbers serve all channels: grey layers give no colour noise.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/transform.glsl"
#include "common/material.glsl"
#include "common/layer_depth.glsl"
#include "common/shared_hash.h"
#include "stochastic_transparency/subset.glsl"
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_opaqueDepth;
layout(location = 3) in vec4 v_uv;
layout(location = 4) in vec4 v_color;
layout(location = 0) out vec4 o_depth0;
layout(location = 1) out vec4 o_depth1;
layout(location = 2) out vec4 o_depth2;
layout(location = 3) out vec4 o_depth3;

vec4 depthsOf(float depth, uvec3 kept, uint s) {
  // -1 lies behind everything.
  return vec4(mix(vec3(-1), vec3(depth), notEqual(kept & (1u << s), uvec3(0))), -1);
}

void main() {
  OpticsData optics = lightOptics(material, v_uv, v_color);
  float depth = layerDepth();
  if (hiddenBy(texelFetch(t_opaqueDepth, ivec2(gl_FragCoord.xy), 0).r, depth)) discard;
  uint triangle = floatBitsToUint(triangles[INSTANCE_FIRST_TRIANGLE + uint(gl_PrimitiveID)].normalKey.w);
  uint key = surfaceKey(INSTANCE_MESH_KEY, INSTANCE_KEY, triangle);
  uvec3 kept;
  for (int c = 0; c < 3; ++c) kept[c] = keptSamples(1.0 - optics.behind[c], key);
  if (kept == uvec3(0)) discard;
  o_depth0 = depthsOf(depth, kept, 0u);
  o_depth1 = depthsOf(depth, kept, 1u);
  o_depth2 = depthsOf(depth, kept, 2u);
  o_depth3 = depthsOf(depth, kept, 3u);
}
