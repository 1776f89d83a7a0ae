// What techniques in screen space have found for the layer of receivers at hand: four lights a layer
// of the mask.
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE)) uniform sampler2DArray shadowMask;
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE), std430) readonly buffer MaskSlotBlock {
  uint maskSlots[];  // of each light in view; NO_SHADOW: nothing casts in it
};

// Share of a light that arrives at a pixel.
float maskedLight(uint light, uvec2 pixel) {
  uint slot = maskSlots[light];
  if (slot == NO_SHADOW) return 1.0;
  return texelFetch(shadowMask, ivec3(pixel, slot / 4u), 0)[slot % 4u];
}
