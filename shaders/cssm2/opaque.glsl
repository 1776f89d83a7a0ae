// Pass A: an opaque caster's depth into all three channels.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
#include "common/caster_depth.glsl"
layout(location = 3) LIGHT_INPUT vec4 v_uv;
layout(location = 4) LIGHT_INPUT vec4 v_color;
layout(location = 0) out vec4 o_depths;

void main() {
  float depth = storeDepth();
  if (kMasked && lightOptics(material, v_uv, v_color).alpha < 0.5)
    discard;
  o_depths = vec4(vec3(depth), 1);
}
