// Those of a list, the last one first.
layout(binding = SLOT_STORAGE(STORAGE_LIGHT_LOOP), std430) readonly buffer ListBlock {
  uint listed[];
};
struct LightLoop {
  uint light, left;
};

LightLoop beginLights(Receiver r) { return LightLoop(0u, uint(listed.length())); }

bool nextLight(inout LightLoop loop) {
  if (loop.left == 0u) return false;
  loop.light = listed[--loop.left];
  return true;
}
