#ifndef RECEDING_DEPTH_GLSL
#define RECEDING_DEPTH_GLSL
// Depth of a caster that rises before itself, as a map holds it: on the concave side of a triangle
// pushed away from the light by what the triangle's plane rises over the reach of a lookup. Between
// a receiver and a texel of its filter a concave surface rises no faster than it does at the texel,
// so the stored depth lies at or behind every receiver within reach; what remains is a contact gap
// of (N + 1) / 2 texels' slope (spec 01). Include scene.glsl and light_pass.glsl before; the
// including shader declares what it writes.
#include "common/instance_ids.glsl"
layout(constant_id = 15) const float kRecedes = 0.0;  // reach of lookups, texels; 0: exact depth
// As of receivers (common/light_space.glsl).
#define RECEDING_TAN_MAX 10.0

float recedingDepth() {
  float depth = gl_FragCoord.z;
  vec2 gradient = vec2(dFdx(depth), dFdy(depth));
  if (kRecedes == 0.0) return depth;
  uint sides = concaveSides(triangles[INSTANCE_FIRST_TRIANGLE + uint(gl_PrimitiveID)]);
  if ((sides & (gl_FrontFacing ? 1u : 2u)) == 0u) return depth;
  ShadowViewData view = shadowViewAt(PASS_SHADOW_VIEW);
  // Depth that a texel spans on a plane at 45 degrees.
  float unit = view.texel.z * (view.texel.w > 0.0 ? depth
                                                  : length(vec3(view.toClip[0].z, view.toClip[1].z,
                                                                view.toClip[2].z)));
  float steep = length(gradient), most = RECEDING_TAN_MAX * unit;
  if (steep > most) gradient *= most / steep;
  precise float receding = depth - kRecedes * (abs(gradient.x) + abs(gradient.y));
  return max(receding, 0.0);
}
#endif
