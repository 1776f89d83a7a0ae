// One light after the other, all of them.
struct LightLoop {
  uint light, next;
};

LightLoop beginLights(Receiver r) { return LightLoop(0u, 0u); }

bool nextLight(inout LightLoop loop) {
  loop.light = loop.next++;
  return loop.light < frame.counts.x;
}
