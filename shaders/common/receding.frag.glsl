#version 450
// Depth of an opaque caster that rises before itself.
#include "common/scene.glsl"
#define RECEDES
#include "common/caster_depth.glsl"

void main() { storeDepth(); }
