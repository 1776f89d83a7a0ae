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

// Share of the light that the edge uncovers there (G of spec 08).
float wedgeShare(WedgeReceiver r, WedgeData w) {
  return w.start.w * edgeShare(r.sight, seenPoint(r.sight, w.start.xyz - r.position),
                               seenPoint(r.sight, w.end.xyz - r.position));
}

// So near the plane through the edge and the light's centre that the count of volumes, whose
// vertices snap to 1/256 of a pixel, may see the receiver on its other side.
bool isAtHardEdge(WedgeReceiver r, WedgeData w) {
  vec3 a = w.start.xyz - r.position, b = w.end.xyz - r.position;
  vec3 n = r.directional ? cross(b - a, r.toLight) : cross(a - r.toLight, b - r.toLight);
  return abs(dot(n, a)) < r.pixel * length(n);
}
