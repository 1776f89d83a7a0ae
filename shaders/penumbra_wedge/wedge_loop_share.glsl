// What an edge tells about the loop that it is part of (the thesis, section 4.4): the light's centre
// lies outside; the edge crosses the light; and what it hides, -G.
#include "penumbra_wedge/wedges.glsl"
layout(location = 0) flat in uint v_wedge;
layout(location = 0) out vec4 o_loop;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2D receiverDepth;

void main() {
  float depth = texelFetch(receiverDepth, ivec2(gl_FragCoord.xy), 0).r;
  if (depth == 0.0) discard;
  WedgeReceiver r = wedgeReceiver(gl_FragCoord.xy, depth);
  if (r.sight.seen == SEEN_FROM_WITHIN) discard;
  WedgeData w = wedges[v_wedge];
  SeenEdge edge = seenEdge(r.sight, seenPoint(r.sight, w.start.xyz - r.position),
                           seenPoint(r.sight, w.end.xyz - r.position));
  if (!crossesLight(r.sight, edge)) discard;
  o_loop = vec4(0, edge.left ? 0.0 : 1.0, 1, -wedgeShare(r, w));
}
