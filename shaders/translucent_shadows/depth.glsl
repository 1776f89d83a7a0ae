// Nearest translucent surface: what is not there takes no part (spec 02, P2).
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
#include "common/caster_depth.glsl"
layout(location = 3) in vec4 v_uv;
layout(location = 4) in vec4 v_color;

void main() {
  storeDepth();
  if (lightOptics(material, v_uv, v_color).alpha < 1.0 / 512.0) discard;
}
