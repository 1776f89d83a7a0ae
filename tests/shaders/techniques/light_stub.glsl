// Stands in for the scene's buffers, so that the filters of the techniques can be asked alone.
#include "common/shared_slots.h"
#include "common/shared_types.h"
LightData lightAt(uint) {
  LightData none;
  return none;
}
ShadowViewData shadowViewAt(uint) {
  ShadowViewData none;
  return none;
}
#include "common/transform.glsl"
#include "common/receiver.glsl"

struct Query {
  vec4 uvzBias;
  vec4 gradient;  // xy
};
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE), std430) readonly buffer Queries { Query queries[]; };
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE + 1), std430) writeonly buffer Answers { vec4 answers[]; };
layout(local_size_x = 64) in;
