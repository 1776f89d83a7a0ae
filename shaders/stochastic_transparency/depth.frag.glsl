#version 450
// A stochastic depth map from the camera: in each sample the nearest fragment that keeps it. The
// depth is that of the pixel's centre in all samples, as in every other pass.
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

void main() {
  float alpha = lightOptics(material, v_uv, v_color).alpha;
  float depth = layerDepth();
  if (hiddenBy(texelFetch(t_opaqueDepth, ivec2(gl_FragCoord.xy), 0).r, depth)) discard;
  uint triangle = floatBitsToUint(triangles[INSTANCE_FIRST_TRIANGLE + uint(gl_PrimitiveID)].normalKey.w);
  uint kept = keptSamples(alpha, surfaceKey(INSTANCE_MESH_KEY, INSTANCE_KEY, triangle));
  // Without multisampling a sample mask means nothing to OpenGL.
  if (alpha <= 0.0 || kept == 0u) discard;
  gl_SampleMask[0] = int(kept);
  gl_FragDepth = depth;
}
