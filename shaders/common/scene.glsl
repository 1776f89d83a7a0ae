// The scene as shaders see it: bindings common to every pass.
#include "common/shared_slots.h"
#include "common/shared_types.h"

layout(binding = SLOT_UNIFORM(UNIFORM_DRAW), std140) uniform DrawBlock { DrawData draw; };
layout(binding = SLOT_UNIFORM(UNIFORM_FRAME), std140) uniform FrameBlock { FrameData frame; };
layout(binding = SLOT_STORAGE(STORAGE_INSTANCES), std430) readonly buffer InstanceBlock {
  InstanceData instances[];
};
layout(binding = SLOT_STORAGE(STORAGE_MATERIALS), std430) readonly buffer MaterialBlock {
  MaterialData materials[];
};
layout(binding = SLOT_STORAGE(STORAGE_LIGHTS), std430) readonly buffer LightBlock {
  LightData lights[];
};
layout(binding = SLOT_STORAGE(STORAGE_SHADOW_VIEWS), std430) readonly buffer ShadowViewBlock {
  ShadowViewData shadowViews[];
};
layout(binding = SLOT_STORAGE(STORAGE_TRIANGLES), std430) readonly buffer TriangleBlock {
  TriangleData triangles[];
};

// Concave sides of a triangle, 1 that of its normal, 2 the other: what the normal's length says.
uint concaveSides(TriangleData t) {
  float squared = dot(t.normalKey.xyz, t.normalKey.xyz);
  return squared > 32.0 ? 3u : squared > 8.0 ? 2u : squared > 2.0 ? 1u : 0u;
}
