// The receiver at hand: from interpolated attributes and the triangle's own record.
#include "common/instance_ids.glsl"
#define SURFACE_IO in
#include "common/surface_io.glsl"
#include "common/shared_hash.h"

layout(binding = SLOT_STORAGE(STORAGE_TRIANGLE_ORDER), std430) readonly buffer TriangleOrderBlock {
  uint triangleOrder[];
};

// Number of the triangle at hand in its mesh.
#define HAS_TRIANGLE_ORDER
uint currentTriangleIndex() {
  uint index = uint(gl_PrimitiveID);
  // Triangles sorted one by one come through a list of their numbers.
  return kTriangleOrder ? triangleOrder[v_firstOrdered + index] : index;
}

TriangleData currentTriangle() {
  return triangles[INSTANCE_FIRST_TRIANGLE + currentTriangleIndex()];
}

// Persistent key of the surface at hand (decision D2).
uint currentSurfaceKey() {
  return surfaceKey(INSTANCE_MESH_KEY, INSTANCE_KEY, floatBitsToUint(currentTriangle().normalKey.w));
}

Receiver surfaceReceiver(vec3 position) {
  Receiver r;
  r.position = position;
  r.dpdx = dFdx(position);
  r.dpdy = dFdy(position);
  TriangleData t = currentTriangle();
  vec3 n = throughRows(v_normalRow0, v_normalRow1, v_normalRow2, t.normalKey.xyz);
  n = n * inversesqrt(max(dot(n, n), 1e-38));
  r.normal = dot(n, position) > 0.0 ? -n : n;
  r.instance = INSTANCE;
  r.mesh = INSTANCE_MESH_KEY;
  r.key = surfaceKey(INSTANCE_MESH_KEY, INSTANCE_KEY, floatBitsToUint(t.normalKey.w));
  r.pixel = uvec2(gl_FragCoord.xy);
  r.kind = RECEIVER_SURFACE;
  r.concave = concaveSides(t);
  // As the normal was turned.
  if (dot(n, position) > 0.0) r.concave = (r.concave >> 1) | ((r.concave & 1u) << 1);
  return r;
}
