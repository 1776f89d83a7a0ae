#version 450
// Half of a wedge (spec 08, SPLIT_HALVES): between the plane through the edge and the light's
// centre and the one before it or behind. In the first it has the triangles of the edge's volume, to
// the last bit, so that no receiver lies in a half and on the volume's other side.
#include "penumbra_wedge/wedges.glsl"
#include "common/transform.glsl"
layout(constant_id = 16) const bool kInner = false;  // where the light's centre is hidden
layout(location = 0) flat out uint v_wedge;
invariant gl_Position;

// Near end, its partner in the hull, the half's ways from both, ways within the plane from both, far
// end, ways of light through both ends: of twelve triangles.
const uint kCorners[36] =
    uint[](0u, 6u, 1u, 7u, 0u, 4u, 6u, 8u, 5u, 1u, 6u, 5u, 0u, 1u, 3u, 0u, 3u, 2u, 0u, 2u, 4u, 3u,
           1u, 5u, 2u, 3u, 5u, 2u, 5u, 8u, 2u, 8u, 7u, 2u, 7u, 4u);

// As common/volume_vertex.glsl has it.
vec4 farVertex(WedgeData w, vec3 position, vec3 d) {
  precise vec4 c = frame.viewProjection[0] * d.x + frame.viewProjection[1] * d.y +
                   frame.viewProjection[2] * d.z;
  if (w.throughStart.w == 0.0) return c;
  LightData light = lightAt(wedgeLight.ids.x);
  vec3 start = light.ids.x == LIGHT_DIRECTIONAL ? position : light.positionRange.xyz;
  precise vec4 e = c + w.throughStart.w * toClip(frame.viewProjection, start);
  return e;
}

// Between two ways (or points) of the hull, where they cross the plane.
vec4 inPlane(vec3 normal, vec3 from, vec4 before, vec4 behind) {
  float a = abs(dot(normal, before.xyz - before.w * from));
  float b = abs(dot(normal, behind.xyz - behind.w * from));
  return a + b > 0.0 ? (before * b + behind * a) / (a + b) : before;
}

vec4 halfVertex(WedgeData w, uint vertex) {
  vec3 a = w.start.xyz, b = w.end.xyz;
  vec4 nearA = toClip(frame.viewProjection, a), nearB = toClip(frame.viewProjection, b);
  vec4 farA = farVertex(w, a, w.throughStart.xyz), farB = farVertex(w, b, w.throughEnd.xyz);
  // The side of the edge's volume.
  if (vertex < 6u) {
    if (vertex == 0u || vertex == 3u) return nearB;
    if (vertex == 1u) return nearA;
    return vertex == 5u ? farB : farA;
  }
  bool fromEnd = distance(w.hull[0].xyz, b) < distance(w.hull[0].xyz, a);
  // The volume's side is wound one way; the others are wound to meet it.
  uint k = (vertex - 6u) % 3u, first = vertex - k;
  uint corner = kCorners[first - 6u + (fromEnd && k < 2u ? 1u - k : k)];
  if (corner == 0u) return fromEnd ? nearB : nearA;
  if (corner == 6u) return fromEnd ? nearA : nearB;
  if (corner == 7u) return fromEnd ? farB : farA;
  if (corner == 8u) return fromEnd ? farA : farB;
  if (corner == 1u) return frame.viewProjection * w.hull[1];
  // Toward the occluder.
  vec3 inward = cross(b - a, w.throughStart.xyz);
  uint end = (corner & 1u) == 0u ? 0u : 1u;
  vec4 before = w.hull[2u + 2u * end], behind = w.hull[3u + 2u * end];
  vec3 from = w.hull[end].xyz;
  if (corner >= 4u) return frame.viewProjection * inPlane(inward, from, before, behind);
  bool innerBefore = dot(inward, before.xyz - before.w * from) > 0.0;
  return frame.viewProjection * (innerBefore == kInner ? before : behind);
}

void main() {
  v_wedge = uint(gl_VertexIndex) / WEDGE_HALF_VERTICES;
  gl_Position = halfVertex(wedges[v_wedge], uint(gl_VertexIndex) % WEDGE_HALF_VERTICES);
}
