// Four lights a layer of the mask, which was made for the layer of receivers at hand.
layout(constant_id = 16) const float kLeast = 0.0;  // share of light that a shadow leaves
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2DArray shadowMask;
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE), std430) readonly buffer MaskSlotBlock {
  uint maskSlots[];  // of each light in view; NO_SHADOW: nothing casts in it
};

vec3 lightVisibility(uint light, Receiver r) {
  uint slot = maskSlots[light];
  if (slot == NO_SHADOW) return vec3(1);
  float lit = texelFetch(shadowMask, ivec3(r.pixel, slot / 4u), 0)[slot % 4u];
  return vec3(max(lit, kLeast));
}
