// The visibility buffer (decision D10): the technique's bare answer for one light, at one layer of
// surfaces. Layers are peeled by depth: a fragment at or before the previous layer, or behind the
// first opaque surface, is not of this layer. Surfaces that lie over one another in one plane have
// depths one step apart, in the order of their keys, opaque ones first: so each translucent one is a
// layer, the same as the truth's, and none that lies in the opaque surface is.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/transform.glsl"
#include "common/material.glsl"
#include "common/receiver.glsl"
#include <technique/visibility.glsl>
#include "common/surface.glsl"
#include "common/layer_depth.glsl"
layout(binding = SLOT_UNIFORM(UNIFORM_PASS), std140) uniform PassBlock { uvec4 passIds; };
layout(binding = SLOT_TEXTURE(TEXTURE_PREVIOUS_LAYER)) uniform sampler2D t_previousLayer;
layout(binding = SLOT_TEXTURE(TEXTURE_TRANSPARENCY)) uniform sampler2D t_opaqueDepth;
layout(location = 0) out vec4 o_visibility;

#define PASS_LIGHT passIds.x
#define PASS_LAYER passIds.y  // 0: first opaque surface, no peeling; n: n-th layer

void main() {
  Receiver r = surfaceReceiver(v_position);
  OpticsData optics = opticsAt(material, baseColorAt(material, v_uv, v_color), v_uv);
  if (optics.alpha <= 0.0) discard;
  float depth = layerDepth();
  if (PASS_LAYER > 0u) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (depth > texelFetch(t_opaqueDepth, pixel, 0).r) discard;
    if (PASS_LAYER > 1u && depth <= texelFetch(t_previousLayer, pixel, 0).r) discard;
  }
#ifdef WRITES_DEPTH
  gl_FragDepth = depth;
#endif
  o_visibility = vec4(lightVisibility(PASS_LIGHT, r), 1);
}
