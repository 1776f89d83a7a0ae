// The scene as shaders see it: bindings common to every pass. Lights and their views stand in uniform
// blocks of one or a power of four elements (each pipeline is made for such a length), so that the one
// light of most scenes is read from fixed places; lists too long for a block are read from storage.
#include "common/shared_slots.h"
#include "common/shared_types.h"
layout(constant_id = 5) const uint kLights = 1u;              // at least 1
layout(constant_id = 6) const uint kShadowViews = 1u;         // at least 1
layout(constant_id = 7) const bool kLightsInStorage = false;  // the lists are longer than that

layout(binding = SLOT_UNIFORM(UNIFORM_MATERIAL), std140) uniform MaterialBlock {
  MaterialData material;  // of all instances of a draw
};
layout(binding = SLOT_UNIFORM(UNIFORM_FRAME), std140) uniform FrameBlock { FrameData frame; };
layout(binding = SLOT_UNIFORM(UNIFORM_LIGHTS), std140) uniform LightBlock {
  LightData lights[kLights];
};
layout(binding = SLOT_UNIFORM(UNIFORM_SHADOW_VIEWS), std140) uniform ShadowViewBlock {
  ShadowViewData shadowViews[kShadowViews];
};
layout(binding = SLOT_STORAGE(STORAGE_LIGHTS), std430) readonly buffer StoredLightBlock {
  LightData storedLights[];
};
layout(binding = SLOT_STORAGE(STORAGE_SHADOW_VIEWS), std430) readonly buffer StoredViewBlock {
  ShadowViewData storedViews[];
};
layout(binding = SLOT_STORAGE(STORAGE_TRIANGLES), std430) readonly buffer TriangleBlock {
  TriangleData triangles[];
};

LightData lightAt(uint index) {
  if (kLightsInStorage) return storedLights[index];
  return lights[kLights == 1u ? 0u : index];
}

ShadowViewData shadowViewAt(uint index) {
  if (kLightsInStorage) return storedViews[index];
  return shadowViews[kShadowViews == 1u ? 0u : index];
}

// Concave sides of a triangle, 1 that of its normal, 2 the other: what the normal's length says.
uint concaveSides(TriangleData t) {
  float squared = dot(t.normalKey.xyz, t.normalKey.xyz);
  return squared > 32.0 ? 3u : squared > 8.0 ? 2u : squared > 2.0 ? 1u : 0u;
}
