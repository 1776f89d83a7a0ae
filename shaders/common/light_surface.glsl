// A caster whose alpha or transmission varies, as the light sees it.
#include "common/scene.glsl"
#include "common/light_pass.glsl"
#include "common/instance.glsl"
#include "common/vertex_attributes.glsl"
layout(location = 3) LIGHT_OUTPUT vec4 v_uv;
layout(location = 4) LIGHT_OUTPUT vec4 v_color;

void main() {
  v_uv = vec4(a_uv0, a_uv1);
  v_color = a_color;
  gl_Position = toLightClip(placeInstance(a_position));
}
