// Depth of a perforated caster: discards where the alpha mask says so.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
#include "common/caster_depth.glsl"
layout(location = 3) in vec4 v_uv;
layout(location = 4) in vec4 v_color;

void main() {
  storeDepth();
  if (lightOptics(material, v_uv, v_color).alpha < 0.5) discard;
}
