// Which fragments are of a layer of the visibility buffer (decision D10): a fragment at or before the
// previous layer, or behind the first opaque surface, is not. Surfaces that lie over one another in
// one plane have depths one step apart, in the order of their keys, opaque ones first: so each
// translucent one is a layer, the same as the truth's, and none that lies in the opaque surface is.
#include "common/layer_depth.glsl"
layout(binding = SLOT_UNIFORM(UNIFORM_PASS), std140) uniform PassBlock { uvec4 passIds; };
layout(binding = SLOT_TEXTURE(TEXTURE_PREVIOUS_LAYER)) uniform sampler2D t_previousLayer;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_opaqueDepth;

#define PASS_LIGHT passIds.x
#define PASS_LAYER passIds.y  // 0: first opaque surface, no peeling; n: n-th layer

void discardUnlessInLayer(float alpha) {
  if (alpha <= 0.0) discard;
  float depth = layerDepth();
  if (PASS_LAYER > 0u) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (depth < texelFetch(t_opaqueDepth, pixel, 0).r) discard;
    if (PASS_LAYER > 1u && depth >= texelFetch(t_previousLayer, pixel, 0).r) discard;
  }
#ifdef WRITES_DEPTH
  gl_FragDepth = depth;
#endif
}
