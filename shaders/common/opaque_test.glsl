// The test against the opaque surface in the shader, where surfaces lie in one plane with it
// (TESTS_OPAQUE); else the depth test of the pass decides, and this does nothing.
#ifdef TESTS_OPAQUE
#include "common/layer_depth.glsl"
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_opaqueDepth;
bool behindOpaque() {
  return hiddenBy(texelFetch(t_opaqueDepth, ivec2(gl_FragCoord.xy), 0).r, layerDepth());
}
#else
bool behindOpaque() { return false; }
#endif
