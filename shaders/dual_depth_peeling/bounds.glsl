// One step inward from both sides. Fragments between the bounds vote for the next ones and are not
// shaded. Depth is 1 near .. 0 far: bounds are (near, -far), MAX blended; (-2, -2) says that nothing is
// left: no depth lies between -2 and 2.
#include "common/layer_depth.glsl"
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_opaqueDepth;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY + 1)) uniform sampler2D t_bounds;
layout(location = 0) out vec2 o_bounds;

bool g_isFront;

// Whether the fragment is at a bound; discards what is beyond.
bool atBound() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = layerDepth();
  if (hiddenBy(texelFetch(t_opaqueDepth, pixel, 0).r, depth)) discard;
  vec2 bounds = texelFetch(t_bounds, pixel, 0).rg;
  float near = bounds.x, far = -bounds.y;
  if (depth > near || depth < far) discard;
  bool between = depth < near && depth > far;
  o_bounds = between ? vec2(depth, -depth) : vec2(-2);
  // The middle one of an odd number is at both bounds: front, and only once.
  g_isFront = depth == near;
  return !between;
}
