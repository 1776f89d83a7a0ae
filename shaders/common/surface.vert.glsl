#version 450
// A surface as the camera sees it.
#include "common/scene.glsl"
#include "common/instance.glsl"
#include "common/vertex_attributes.glsl"
#define SURFACE_IO out
#include "common/surface_io.glsl"
// Passes that draw a surface again meet its depth to the last bit.
invariant gl_Position;
layout(location = 10) in uvec4 a_order;
layout(location = 11) in vec4 a_normalRow0;
layout(location = 12) in vec4 a_normalRow1;
layout(location = 13) in vec4 a_normalRow2;

void main() {
  vec3 p = placeInstance(a_position);
  v_position = p;
  v_firstOrdered = a_order.x;
  v_normalRow0 = a_normalRow0.xyz;
  v_normalRow1 = a_normalRow1.xyz;
  v_normalRow2 = a_normalRow2.xyz;
  v_normal = throughRows(v_normalRow0, v_normalRow1, v_normalRow2, a_normal) * a_normalRow0.w;
  v_tangent = vec4(
      throughRows(a_toRelative0.xyz, a_toRelative1.xyz, a_toRelative2.xyz, a_tangent.xyz), a_tangent.w);
  v_uv = vec4(a_uv0, a_uv1);
  v_color = a_color;
  gl_Position = toClip(frame.viewProjection, p);
}
