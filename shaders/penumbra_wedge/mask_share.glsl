// The share of the light that arrives, from what volumes and wedges have added up.
#include "penumbra_wedge/wedges.glsl"
#include "penumbra_wedge/exact.glsl"
layout(constant_id = 16) const uint kSums = SUMS_NONE;
layout(constant_id = 17) const bool kExactly = true;  // by casters: without sums, or where they are off
layout(constant_id = 18) const bool kWrapped = false; // one caster, whose share is between 0 and 1
layout(constant_id = 19) const float kLeast = 0.0;    // beyond what rounding of sums leaves
layout(location = 0) out vec4 o_share;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2D receiverDepth;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 1)) uniform sampler2D addedShares;

// What count and shares disagree about is 1.
float wrapped(float hidden) {
  return hidden > 1.0 + kLeast ? hidden - 1.0 : hidden < -kLeast ? hidden + 1.0 : hidden;
}

void main() {
  vec4 added = kSums == SUMS_NONE ? vec4(0) : texelFetch(addedShares, ivec2(gl_FragCoord.xy), 0);
  float hidden = added.r;
  bool unsure = kSums == SUMS_NONE;
  if (kSums == SUMS_APART) {
    hidden += added.g;
    unsure = added.b > 0.0;
  } else if (kSums == SUMS_BYTES) {
    hidden = (added.r - added.g) * 255.0 - (added.b - added.a) * (255.0 / 32.0);
    // Bytes have no room for where count and shares may disagree: only where they are seen to.
    unsure = wrapped(hidden) != hidden;
  }
  if (kWrapped) hidden = wrapped(hidden);
  if (kExactly && unsure) {
    float depth = texelFetch(receiverDepth, ivec2(gl_FragCoord.xy), 0).r;
    WedgeReceiver r = wedgeReceiver(gl_FragCoord.xy, depth);
    if (depth == 0.0 || r.sight.seen == SEEN_FROM_WITHIN)
      hidden = 0.0;
    else  // shares are right: only the count may be another
      hidden = kSums == SUMS_APART ? centreHiddenByAll(r) + added.g : hiddenByAll(r);
  }
  hidden = clamp(hidden, 0.0, 1.0);
  // Of one caster after another the shares are taken off what is left.
  o_share = vec4(kWrapped ? hidden : 1.0 - hidden);
}
