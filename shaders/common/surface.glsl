// The receiver at hand: from interpolated attributes and the triangle's own record.
#include "common/shared_hash.h"

layout(binding = SLOT_STORAGE(STORAGE_TRIANGLE_ORDER), std430) readonly buffer TriangleOrderBlock {
  uint triangleOrder[];
};

// Number of the triangle at hand in its mesh.
#define HAS_TRIANGLE_ORDER
uint currentTriangleIndex() {
  uint index = uint(gl_PrimitiveID);
  // Triangles sorted one by one come through a list of their numbers.
  return kTriangleOrder ? triangleOrder[draw.ids.y + index] : index;
}

TriangleData currentTriangle(InstanceData i) {
  return triangles[i.ids.z + currentTriangleIndex()];
}

// Persistent key of the surface at hand (decision D2).
uint currentSurfaceKey(InstanceData i) {
  return surfaceKey(i.ids.w, i.ids.y, floatBitsToUint(currentTriangle(i).normalKey.w));
}

Receiver surfaceReceiver(InstanceData i, vec3 position) {
  Receiver r;
  r.position = position;
  r.dpdx = dFdx(position);
  r.dpdy = dFdy(position);
  TriangleData t = currentTriangle(i);
  vec3 n = normalToWorld(i, t.normalKey.xyz);
  n = n * inversesqrt(max(dot(n, n), 1e-38));
  r.normal = dot(n, position) > 0.0 ? -n : n;
  r.instance = draw.ids.x;
  r.mesh = i.ids.w;
  r.key = surfaceKey(i.ids.w, i.ids.y, floatBitsToUint(t.normalKey.w));
  r.pixel = uvec2(gl_FragCoord.xy);
  r.kind = RECEIVER_SURFACE;
  r.concave = concaveSides(t);
  // As the normal was turned.
  if (dot(n, position) > 0.0) r.concave = (r.concave >> 1) | ((r.concave & 1u) << 1);
  return r;
}
