// Vertices of shadow volumes, in clip space. A volume consists of items: an item of the sides is twice
// an edge, and one more if it runs from high to low; an item of the caps is a triangle. Whatever
// finds the items, each has its vertices from here, so that all builds draw the same bits.
#include "common/scene.glsl"
#include "common/transform.glsl"
#include "common/volume_mesh.glsl"
layout(constant_id = 16) const uint kPart = VOLUME_SIDES;
layout(constant_id = 17) const bool kFinite = false;
layout(constant_id = 20) const uint kCaps = CAPS_BOTH;

// The same sums as for the surface: caps meet its depth to the last bit.
vec3 relativeVertex(uint vertex) {
  return toRelative(volume.row0, volume.row1, volume.row2, positionOf(vertex));
}

vec4 nearVertex(uint vertex) { return toClip(frame.viewProjection, relativeVertex(vertex)); }

// Away from the light: at infinity, where w = 0, or so near it that all that is seen lies before; or
// at its distance.
vec4 farVertex(uint vertex) {
  precise vec3 d = lightThrough(volume, positionOf(vertex));
  bool local = volume.light.w != 0.0;
  if (kFinite) {
    float length = sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    // What lies beyond already ends behind itself: no far cap meets the caster's own depth.
    float way = local ? max(volume.extent.w - length, 0.015625 * volume.extent.w) : volume.extent.w;
    precise vec3 p = relativeVertex(vertex) + d * (way / length);
    return toClip(frame.viewProjection, p);
  }
  precise vec4 c = frame.viewProjection[0] * d.x + frame.viewProjection[1] * d.y +
                   frame.viewProjection[2] * d.z;
  if (volume.extent.w == 0.0) return c;
  // Light + d / w, directional: vertex + d / w, times w.
  vec3 start = local ? volume.extent.xyz : relativeVertex(vertex);
  precise vec4 e = c + volume.extent.w * toClip(frame.viewProjection, start);
  return e;
}

vec4 sideVertex(uint item, uint corner) {
  uvec4 ends = edgeAt(item >> 1).ends;
  uint a = (item & 1u) == 0u ? ends.x : ends.y;
  uint b = (item & 1u) == 0u ? ends.y : ends.x;
  // (b, a, far a), (b, far a, far b): counter-clockwise from outside.
  if (corner == 0u || corner == 3u) return nearVertex(b);
  if (corner == 1u) return nearVertex(a);
  return farVertex(corner == 5u ? b : a);
}

vec4 capVertex(uint triangle, uint corner) {
  bool atCaster = corner < 3u;
  // Triangles that are not drawn have no area.
  if (kCaps == CAPS_FAR ? atCaster : kCaps != CAPS_BOTH && !atCaster) return vec4(2, 2, 2, 1);
  if (kCaps == CAPS_BEYOND) {
    // Clipping leaves what lies beyond z = 0, the far plane; where it cuts does not depend on a
    // power of two. Small, so that nothing is cut off farther out.
    vec4 p = nearVertex(cornerAt(triangle, corner));
    return vec4(p.xy, p.z * -9.5367431640625e-7, p.w);
  }
  // The far end is turned over.
  return atCaster ? nearVertex(cornerAt(triangle, corner))
                  : farVertex(cornerAt(triangle, 5u - corner));
}

uint verticesOfItem() { return kPart == VOLUME_SIDES ? volume.vertices.x : volume.vertices.y; }

vec4 itemVertex(uint item, uint corner) {
  return kPart == VOLUME_SIDES ? sideVertex(item, corner) : capVertex(item, corner);
}

// How many items of this part an edge or a triangle needs.
uint itemsAt(uint at, out uint item) {
  if (kPart == VOLUME_SIDES) {
    int m = sidesOf(edgeAt(at));
    item = 2u * at + (m < 0 ? 1u : 0u);
    return uint(abs(m));
  }
  int sign = triangleCasts(at);
  item = at;
  return sign != 0 && capPart(sign) == kPart ? 1u : 0u;
}
