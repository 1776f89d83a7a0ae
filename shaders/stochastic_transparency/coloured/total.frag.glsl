#version 450
// Transmittance of all layers of a pixel by channel, exact: multiplied by blending, in any order.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
#include "common/layer_depth.glsl"
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_opaqueDepth;
layout(location = 3) in vec4 v_uv;
layout(location = 4) in vec4 v_color;
layout(location = 0) out vec4 o_transmittance;

void main() {
  OpticsData optics = lightOptics(material, v_uv, v_color);
  if (optics.alpha <= 0.0) discard;
  if (hiddenBy(texelFetch(t_opaqueDepth, ivec2(gl_FragCoord.xy), 0).r, layerDepth())) discard;
  o_transmittance = vec4(optics.behind, 1);
}
