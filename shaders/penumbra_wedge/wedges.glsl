// The wedges and casters of the light at hand, and how a receiver sees that light.
#include "common/scene.glsl"
#include "common/shared_coverage.h"
#include "common/shared_wedge.h"
#include "common/position.glsl"

layout(binding = SLOT_UNIFORM(UNIFORM_TECHNIQUE), std140) uniform WedgeLightBlock {
  WedgeLightData wedgeLight;
};
layout(binding = SLOT_STORAGE(STORAGE_TECHNIQUE), std430) readonly buffer WedgeBlock {
  WedgeData wedges[];
};

// A receiver: a point relative to the eye, and what it sees of the light.
struct WedgeReceiver {
  vec3 position;
  vec3 toLight;  // directional: the way to it
  bool directional;
  float pixel;   // size there, across the ray from the eye
  LightSight sight;
};

// `window`: as gl_FragCoord.xy; `depth`: of the receiver.
WedgeReceiver wedgeReceiver(vec2 window, float depth) {
  LightData light = lightAt(wedgeLight.ids.x);
  WedgeReceiver r;
  r.position = positionOfDepth(window, depth);
  r.directional = light.ids.x == LIGHT_DIRECTIONAL;
  r.toLight = r.directional ? -light.directionScale.xyz : light.positionRange.xyz - r.position;
  float scale = frame.rayForward.w == 0.0 ? distanceOfDepth(depth) : 1.0;
  r.pixel = scale * max(length(frame.rayRight.xyz), length(frame.rayUp.xyz));
  r.sight = lightSight(r.toLight, light.halfAxis0.xyz, light.halfAxis1.xyz, light.halfAxis2.xyz,
                       light.shape.x, r.directional);
  return r;
}

#ifdef COVERAGE_TABLES
// The source's tables of discs: by |d0| and how far the ends are from the foot of the centre, of
// edges whose ends lie on one side of it and of others.
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 2)) uniform sampler3D oneSide;
layout(binding = SLOT_TEXTURE(TEXTURE_TECHNIQUE + 3)) uniform sampler3D bothSides;

float shareOfEdge(LightSight sight, vec3 a, vec3 b) {
  if (sight.seen == SEEN_SQUARE) return edgeShare(sight, a, b);
  SeenEdge edge = seenEdge(sight, a, b);
  if (!edge.any) return 0.0;
  float s1 = dot(edge.start, edge.along), s2 = dot(edge.end, edge.along);
  float size = float(textureSize(oneSide, 0).x);
  vec3 at = (clamp(abs(vec3(edge.d0, s1, s2)), 0.0, 1.0) * (size - 1.0) + 0.5) / size;
  float beyond = s1 * s2 > 0.0 ? textureLod(oneSide, at, 0.0).r : textureLod(bothSides, at, 0.0).r;
  return edge.left ? beyond : -beyond;
}
#else
float shareOfEdge(LightSight sight, vec3 a, vec3 b) { return edgeShare(sight, a, b); }
#endif

// Share of the light that the edge uncovers there (G of spec 08).
float wedgeShare(WedgeReceiver r, WedgeData w) {
  return w.start.w * shareOfEdge(r.sight, seenPoint(r.sight, w.start.xyz - r.position),
                                 seenPoint(r.sight, w.end.xyz - r.position));
}

// So near the light's centre as the edge hides it that the count of volumes, whose vertices snap to
// 1/256 of a pixel, may see the receiver on the other side of the edge. Beyond the edge's ends its
// share is the same on both sides.
bool isAtHardEdge(WedgeReceiver r, WedgeData w) {
  vec3 a = w.start.xyz - r.position, b = w.end.xyz - r.position;
  // Ways of light through both ends; within their plane, across each toward the other.
  vec3 throughA = r.directional ? -r.toLight : a - r.toLight;
  vec3 throughB = r.directional ? -r.toLight : b - r.toLight;
  vec3 n = r.directional ? cross(b - a, r.toLight) : cross(throughA, throughB);
  vec3 fromA = cross(n, throughA), fromB = cross(throughB, n);
  return abs(dot(n, a)) < r.pixel * length(n) && dot(fromA, a) < r.pixel * length(fromA) &&
         dot(fromB, b) < r.pixel * length(fromB);
}
