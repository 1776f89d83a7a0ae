#version 450
#include "cssm1/layered.glsl"
#include "common/vertex_attributes.glsl"
layout(location = 3) out vec4 v_uv;
layout(location = 4) out vec4 v_color;
layout(location = 6) flat out uint v_channel;

void main() {
  v_uv = vec4(a_uv0, a_uv1);
  v_color = a_color;
  v_channel = a_order.y;
  toLayer(a_position);
}
