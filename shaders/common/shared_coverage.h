// How much of a light with an extent an occluder's outline hides from a receiver (spec 08), for C++
// and GLSL. All edges are projected from the receiver onto one plane, the light's, where the
// light is the unit disc or the square [-1, 1]^2, so that vertices that edges share stay shared and
// their shares add up. With outlines counter-clockwise around occluders, `covered = H - sum of
// edgeShare`, H the number of outlines around the light's centre (1: in the hard shadow).
// The source's per-edge planes, orthogonal projection and tables (errata E1-E3) are not used here.
#ifndef SHADOWBENCH_SHARED_COVERAGE_H
#define SHADOWBENCH_SHARED_COVERAGE_H

#ifdef __cplusplus
#include <cmath>

#include "shaders/common/shared_types.h"
namespace sb::gpu {
using glm::atan;
using glm::clamp;
using glm::cross;
using glm::dot;
using glm::length;
using glm::max;
using glm::min;
using glm::sqrt;
using std::abs;
using vec2 = glm::vec2;
using vec3 = glm::vec3;
#define SHARED inline
#define PRECISE
#else  // after common/shared_types.h
#define SHARED
#define PRECISE precise
#endif

// What a receiver sees of a light: a disc, a square; or it lies in the light or in its plane, where
// nothing can be said, and is lit.
#define SEEN_ROUND 0u
#define SEEN_SQUARE 1u
#define SEEN_FROM_WITHIN 2u

// Occluders nearer than this share of the way to the light are the receiver's own surface.
#define NEAREST_OCCLUDER 1e-4f

struct LightSight {
  vec3 rowX;  // take a vector from the receiver to (x, y, z): it is seen at (x, y) / z, and z is 1
  vec3 rowY;  // in the light's plane. Counter-clockwise is as the light sees it.
  vec3 rowZ;
  float far;  // no occluder beyond this z: 1, or anything where light is directional
  uint seen;  // SEEN_*
};

// `centre`: from the receiver to the light (directional: the way to it, of length 1). Half axes and
// shape as in LightData. The patch is techniques/scene/light_area.h's.
SHARED LightSight lightSight(vec3 centre, vec3 axis0, vec3 axis1, vec3 axis2, uint shape,
                             bool directional) {
  LightSight sight;
  sight.far = directional ? 1e30f : 1.0f;
  sight.seen = shape == SHAPE_RECTANGLE ? SEEN_SQUARE : SEEN_ROUND;
  vec3 u = axis0;
  vec3 v = axis1;
  if (shape == SHAPE_ELLIPSOID) {
    // Where the ellipsoid is the unit sphere: the circle in which the cone around it touches it,
    // seen in the plane through its centre.
    vec3 n0 = cross(axis1, axis2);
    float inverse = 1.0f / dot(axis0, n0);
    vec3 d = inverse * vec3(dot(n0, centre), dot(cross(axis2, axis0), centre),
                            dot(cross(axis0, axis1), centre));
    float d2 = dot(d, d);
    if (d2 <= 1.0f) sight.seen = SEEN_FROM_WITHIN;
    vec3 other = abs(d.x) < abs(d.y) ? vec3(1, 0, 0) : vec3(0, 1, 0);
    vec3 x = cross(d, other);
    x = x / length(x);
    vec3 y = cross(d, x) / sqrt(d2);
    float radius = sqrt(d2 / max(d2 - 1.0f, 1e-30f));
    u = radius * (axis0 * x.x + axis1 * x.y + axis2 * x.z);
    v = radius * (axis0 * y.x + axis1 * y.y + axis2 * y.z);
  }
  vec3 across = cross(u, v);
  float volume = dot(across, centre);
  if (volume < 0.0f) {
    v = -v;
    across = -across;
    volume = -volume;
  }
  if (volume <= 1e-6f * length(across) * length(centre)) sight.seen = SEEN_FROM_WITHIN;
  sight.rowX = cross(v, centre) / volume;
  sight.rowY = cross(centre, u) / volume;
  sight.rowZ = across / volume;
  return sight;
}

// `e`: from the receiver to a point. The light is moved aside by 3e-7 of its size: what was modelled
// to lie in a plane with its centre then lies to one side of it, for all edges that meet there.
SHARED vec3 seenPoint(LightSight sight, vec3 e) {
  PRECISE vec3 s = vec3(sight.rowX.x * e.x + sight.rowX.y * e.y + sight.rowX.z * e.z,
                        sight.rowY.x * e.x + sight.rowY.y * e.y + sight.rowY.z * e.z,
                        sight.rowZ.x * e.x + sight.rowZ.y * e.y + sight.rowZ.z * e.z);
  PRECISE vec3 aside = s + s.z * vec3(2.4e-7f, 1.8e-7f, 0.0f);
  return aside;
}

// The line through two seen points: n.xy . q + n.z is positive to its left. The same bits with the
// other sign the other way round.
SHARED vec3 lineThrough(vec3 a, vec3 b) {
  PRECISE vec3 n = vec3(a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y);
  return n;
}

// The light's centre lies to the left. If it is on the line: a point a little to its right does, so
// that a line and its reverse never agree.
SHARED bool isLeft(vec3 line) {
  return line.z != 0.0f ? line.z > 0.0f : line.x != 0.0f ? line.x > 0.0f : line.y > 0.0f;
}

// The part of a segment from t.x to t.y for which a value that goes from `a` to `b` is positive.
SHARED vec2 clipped(vec2 t, float a, float b) {
  if (a < 0.0f && b < 0.0f) return vec2(1, 0);
  if (a < 0.0f) return vec2(max(t.x, a / (a - b)), t.y);
  if (b < 0.0f) return vec2(t.x, min(t.y, a / (a - b)));
  return t;
}

// F of spec 08: of a chord at distance |d0| from the disc's centre the part from its foot to s:
// what lies beyond it, as a share of the disc.
SHARED float discPart(float d0, float s) {
  float d = abs(d0);
  if (d >= 1.0f) return 0.0f;
  float h = sqrt(1.0f - d * d);
  float sc = clamp(s, -h, h);
  // With d 0, atan(0, 0) is anything.
  return (atan(sc, max(d, 1e-30f)) - d * sc) * 0.15915494f;
}

// Where the ray from the square's centre through q leaves it: 0 at (1, -1), counter-clockwise, a
// side 2 long.
SHARED float alongSquare(vec2 q) {
  if (q.x == 0.0f && q.y == 0.0f) return 0.0f;
  if (abs(q.x) >= abs(q.y)) return (q.x > 0.0f ? 1.0f : 5.0f) + q.y / q.x;
  return (q.y > 0.0f ? 3.0f : 7.0f) - q.x / q.y;
}

// The same share of the square, of an edge whose ends lie in it.
SHARED float squareShare(vec2 q1, vec2 q2, bool left) {
  float way = alongSquare(q2) - alongSquare(q1);
  if (way > 4.0f) way -= 8.0f;
  if (way < -4.0f) way += 8.0f;
  // About through the centre: the side decides, by the same arithmetic as H.
  if (abs(way) > 2.0f && (way > 0.0f) != left) way += left ? 8.0f : -8.0f;
  return 0.125f * (way - (q1.x * q2.y - q1.y * q2.x));
}

// An edge as it is seen: what of it lies between receiver and light.
struct SeenEdge {
  bool any;    // false: nothing, or not before the light
  bool left;   // the light's centre lies to its left
  float d0;    // distance of the centre, positive there
  vec2 along;  // its way
  vec2 start;
  vec2 end;
};

// `a`, `b`: seen points.
SHARED SeenEdge seenEdge(LightSight sight, vec3 a, vec3 b) {
  SeenEdge edge;
  vec3 line = lineThrough(a, b);
  float size = sqrt(line.x * line.x + line.y * line.y);
  bool square = sight.seen == SEEN_SQUARE;
  edge.left = isLeft(line);
  edge.along = vec2(line.y, -line.x) / size;
  edge.d0 = line.z / size;
  vec2 t = clipped(vec2(0, 1), a.z - NEAREST_OCCLUDER, b.z - NEAREST_OCCLUDER);
  t = clipped(t, sight.far - a.z, sight.far - b.z);
  if (square) {
    t = clipped(t, a.z - a.x, b.z - b.x);
    t = clipped(t, a.z + a.x, b.z + b.x);
    t = clipped(t, a.z - a.y, b.z - b.y);
    t = clipped(t, a.z + a.y, b.z + b.y);
  }
  // Not past the disc, or the square's corners.
  edge.any = t.x < t.y && abs(line.z) < size * (square ? 1.4142136f : 1.0f);
  // Whole ends to the last bit: edges that share them must agree.
  vec3 p1 = t.x == 0.0f ? a : a + t.x * (b - a);
  vec3 p2 = t.y == 1.0f ? b : a + t.y * (b - a);
  edge.start = vec2(p1.x, p1.y) / p1.z;
  edge.end = vec2(p2.x, p2.y) / p2.z;
  return edge;
}

// Any of it lies before the light, however little it hides.
SHARED bool crossesLight(LightSight sight, SeenEdge edge) {
  if (!edge.any || sight.seen == SEEN_SQUARE) return edge.any;
  float h = sqrt(1.0f - edge.d0 * edge.d0);
  return dot(edge.start, edge.along) < h && dot(edge.end, edge.along) > -h;
}

// G of spec 08: of what lies beyond an edge (seen points, directed) in the angle that it takes up
// around the light's centre, the share of the light; negative where the centre lies to its right.
SHARED float edgeShare(LightSight sight, vec3 a, vec3 b) {
  SeenEdge edge = seenEdge(sight, a, b);
  if (!edge.any) return 0.0f;
  if (sight.seen == SEEN_SQUARE) return squareShare(edge.start, edge.end, edge.left);
  float beyond = discPart(edge.d0, dot(edge.end, edge.along)) -
                 discPart(edge.d0, dot(edge.start, edge.along));
  return edge.left ? beyond : -beyond;
}

// Where the ray from the receiver to the light's centre meets a triangle's plane, 1 at the centre (a
// light without place: at distance 1). Corners are relative to the receiver, not seen points: where
// the light is seen edge-on, those are too large to tell the receiver's own surface from others.
SHARED float wayToPlane(vec3 a, vec3 b, vec3 c, vec3 centre) {
  vec3 n = cross(b - a, c - a);
  return dot(n, a) / dot(n, centre);
}

// A triangle (seen points; z: its wayToPlane) lies between the receiver and the light's centre: by
// the same arithmetic as the signs of edgeShare, so that H and G agree wherever the centre is about
// at an edge.
SHARED bool hidesCentre(LightSight sight, vec3 a, vec3 b, vec3 c, float z) {
  bool left = isLeft(lineThrough(a, b));
  if (isLeft(lineThrough(b, c)) != left || isLeft(lineThrough(c, a)) != left) return false;
  return z > NEAREST_OCCLUDER && z < sight.far;
}

#ifdef __cplusplus
#undef SHARED
#undef PRECISE
}  // namespace sb::gpu
#endif

#endif
