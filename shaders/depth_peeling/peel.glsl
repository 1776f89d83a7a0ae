// Which fragments may be the next layer: those behind the layer before (strictly) and not behind the
// opaque surface. Depths are compared as stored, in D32F: every pass computes the same ones.
#include "common/layer_depth.glsl"
layout(constant_id = 32) const bool kFirstLayer = false;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_opaqueDepth;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY + 1)) uniform sampler2D t_previousDepth;

void discardUnlessNext() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = layerDepth();
  if (hiddenBy(texelFetch(t_opaqueDepth, pixel, 0).r, depth)) discard;
  if (!kFirstLayer && depth >= texelFetch(t_previousDepth, pixel, 0).r) discard;
#ifdef WRITES_DEPTH
  gl_FragDepth = depth;
#endif
}
