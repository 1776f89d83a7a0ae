#version 450
// Transmittance of all layers of a pixel, exact: multiplied by blending, in any order.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
#include "common/layer_depth.glsl"
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_opaqueDepth;
layout(location = 3) in vec4 v_uv;
layout(location = 4) in vec4 v_color;
layout(location = 0) out float o_transmittance;

void main() {
  float alpha = lightOptics(material, v_uv, v_color).alpha;
  if (alpha <= 0.0) discard;
  if (hiddenBy(texelFetch(t_opaqueDepth, ivec2(gl_FragCoord.xy), 0).r, layerDepth())) discard;
  o_transmittance = 1.0 - alpha;
}
