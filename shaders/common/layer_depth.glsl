// Depth of a fragment as layers are told apart. Triangles that lie over one another in one plane take
// it from that plane and from their order in it (techniques/scene/geometry/coplanar_surfaces.h); all others
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
  // Nearer is more; those behind lie as many steps of a float lower.
  uint bits = floatBitsToUint(clamp(depth, 0.0, 1.0));
  return uintBitsToFloat(bits - min(bits, coplanar[record + 3u] & 0xFFFFu));
}

// Is the layer hidden by the opaque surface at its pixel? In the plane of one, it is no layer: the
// rasteriser's depth of that surface is off by as much as vertices move on its grid.
bool hiddenBy(float opaque, float depth) {
  if (kCoplanar && opaque > 0.0) {
    uint record = coplanarRecord();
    if (record != 0u && (coplanar[record + 3u] & 0x10000u) != 0u) {
      float across = abs(uintBitsToFloat(coplanar[record]));
      float up = abs(uintBitsToFloat(coplanar[record + 1u]));
      float rounding = across * gl_FragCoord.x + up * gl_FragCoord.y +
                       abs(uintBitsToFloat(coplanar[record + 2u]));
      return depth - (across + up) * (1.0 / 64.0) - rounding * 1e-6 < opaque;
    }
  }
  return depth < opaque;
}
#endif
