#version 450
// Bounds of all layers of a pixel: (nearest, -farthest) by MAX blending.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
#include "common/layer_depth.glsl"
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_opaqueDepth;
layout(location = 3) in vec4 v_uv;
layout(location = 4) in vec4 v_color;
layout(location = 0) out vec2 o_bounds;

void main() {
  if (lightOptics(material, v_uv, v_color).alpha <= 0.0) discard;
  float depth = layerDepth();
  if (hiddenBy(texelFetch(t_opaqueDepth, ivec2(gl_FragCoord.xy), 0).r, depth)) discard;
  o_bounds = vec2(depth, -depth);
}
