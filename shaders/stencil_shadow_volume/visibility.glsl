// From the mask that the counts of volumes have left.
#include "common/shadow_mask.glsl"
layout(constant_id = 16) const float kLeast = 0.0;  // share of light that a shadow leaves

vec3 lightVisibility(uint light, Receiver r) { return vec3(max(maskedLight(light, r.pixel), kLeast)); }
