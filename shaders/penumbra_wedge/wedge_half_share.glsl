// What an edge hides of the light at the receivers in one half of its wedge, or uncovers, whichever
// side of the edge the light's centre is seen on.
#include "penumbra_wedge/wedges.glsl"
layout(constant_id = 16) const bool kInner = false;
layout(location = 0) flat in uint v_wedge;
layout(location = 0) out vec4 o_hidden;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2D receiverDepth;

void main() {
  // Nothing is discarded: all that is marked in the stencil is cleared.
  WedgeReceiver r =
      wedgeReceiver(gl_FragCoord.xy, texelFetch(receiverDepth, ivec2(gl_FragCoord.xy), 0).r);
  float share = 0.0;
  if (r.sight.seen != SEEN_FROM_WITHIN) share = abs(wedgeShare(r, wedges[v_wedge]));
  o_hidden = vec4(kInner ? -share : share, 0, 0, 0);
}
