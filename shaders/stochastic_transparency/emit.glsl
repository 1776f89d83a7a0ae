// basic: each sample shows the nearest fragment that keeps it.
// corrected: each fragment adds its colour, weighted by opacity, to the samples in which the
// stochastic depth map has nothing nearer; its own samples count.
#include "common/layer_depth.glsl"
#include "stochastic_transparency/subset.glsl"
layout(constant_id = 33) const bool kBasic = false;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_opaqueDepth;
layout(location = 0) out vec4 o_color;

bool beginFragment(float alpha) {
  float depth = layerDepth();
  if (hiddenBy(texelFetch(t_opaqueDepth, ivec2(gl_FragCoord.xy), 0).r, depth)) discard;
  gl_SampleMask[0] = ~0;
  if (kBasic) {
    uint kept = keptSamples(alpha, currentSurfaceKey());
    if (kept == 0u) discard;
    gl_SampleMask[0] = int(kept);
  }
  gl_FragDepth = depth;
  return true;
}

void emitFragment(vec3 radiance, float alpha) {
  o_color = kBasic ? vec4(radiance, 1) : vec4(radiance * alpha, alpha);
}
