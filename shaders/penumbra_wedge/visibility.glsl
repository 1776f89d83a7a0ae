// From the mask that volumes and wedges have left. Where casters overlap it may be below 0.
#include "common/shadow_mask.glsl"

vec3 lightVisibility(uint light, Receiver r) { return vec3(max(maskedLight(light, r.pixel), 0.0)); }
