// What a pass over depth maps stores of a caster: the rasteriser's depth, or, in the shaders for
// casters that rise before themselves (RECEDES), a depth that recedes. Those write it, at the price
// of some early tests, and so are modules of their own. storeDepth() comes before any discard:
// derivatives need the neighbours. Include scene.glsl before.
#ifdef RECEDES
#include "common/transform.glsl"
#include "common/light_pass.glsl"
#include "common/receding_depth.glsl"
layout(depth_less) out float gl_FragDepth;

float storeDepth() {
  float depth = recedingDepth();
  gl_FragDepth = depth;
  return depth;
}
#else
float storeDepth() { return gl_FragCoord.z; }
#endif
