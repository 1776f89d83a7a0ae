// Depth of a fragment as layers are told apart. Triangles that lie over one another in one plane take
// it from that plane and from their order in it (techniques/scene/coplanar_surfaces.h); all others
// have that of the rasteriser.
#ifndef LAYER_DEPTH
#define LAYER_DEPTH
#include "common/instance_ids.glsl"
layout(binding = SLOT_STORAGE(STORAGE_COPLANAR), std430) readonly buffer CoplanarBlock {
  uint coplanar[];
};

uint coplanarRecord() {
  uint first = coplanar[INSTANCE];
  uint triangle = uint(gl_PrimitiveID);
#ifdef HAS_TRIANGLE_ORDER
  triangle = currentTriangleIndex();
#endif
  return first == 0u ? 0u : coplanar[first + triangle];
}

float layerDepth() {
  if (!kCoplanar) return gl_FragCoord.z;
  uint record = coplanarRecord();
  if (record == 0u) return gl_FragCoord.z;
  precise float across = uintBitsToFloat(coplanar[record]) * gl_FragCoord.x;
  precise float up = uintBitsToFloat(coplanar[record + 1u]) * gl_FragCoord.y;
  precise float depth = across + up + uintBitsToFloat(coplanar[record + 2u]);
  uint bits = floatBitsToUint(clamp(depth, 0.0, 1.0)) + (coplanar[record + 3u] & 0xFFFFu);
  return min(uintBitsToFloat(bits), 1.0);
}

// Is the layer hidden by the opaque surface at its pixel? In the plane of one, it is no layer: the
// rasteriser's depth of that surface is off by as much as vertices move on its grid.
bool hiddenBy(float opaque, float depth) {
  if (kCoplanar && opaque < 1.0) {
    uint record = coplanarRecord();
    if (record != 0u && (coplanar[record + 3u] & 0x10000u) != 0u) {
      float slope = abs(uintBitsToFloat(coplanar[record])) + abs(uintBitsToFloat(coplanar[record + 1u]));
      return depth + slope * (1.0 / 64.0) + 1e-6 > opaque;
    }
  }
  return depth > opaque;
}
#endif
