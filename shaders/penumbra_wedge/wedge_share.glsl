// What an edge hides of the light at the receivers in its wedge, beside the count of volumes: -G;
// and whether the two may disagree about the side on which the light's centre is.
#include "penumbra_wedge/wedges.glsl"
layout(constant_id = 16) const uint kSums = SUMS_TOGETHER;
layout(location = 0) flat in uint v_wedge;
layout(location = 0) out vec4 o_hidden;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2D receiverDepth;

void main() {
  float depth = texelFetch(receiverDepth, ivec2(gl_FragCoord.xy), 0).r;
  if (depth == 0.0) discard;
  WedgeReceiver r = wedgeReceiver(gl_FragCoord.xy, depth);
  if (r.sight.seen == SEEN_FROM_WITHIN) discard;
  WedgeData w = wedges[v_wedge];
  float share = wedgeShare(r, w);
  if (kSums == SUMS_TOGETHER) {
    o_hidden = vec4(-share, 0, 0, 0);
  } else if (kSums == SUMS_APART) {
    o_hidden = vec4(0, -share, isAtHardEdge(r, w) ? 1.0 : 0.0, 0);
  } else {
    // What uncovers and what hides, apart, in units of 1/32, eight of which may lie on another.
    o_hidden = vec4(0, 0, round(32.0 * max(vec2(share, -share), 0.0)) / 255.0);
  }
}
