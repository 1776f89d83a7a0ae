#version 450
// A surface as the camera sees it.
#include "common/scene.glsl"
#include "common/transform.glsl"
#include "common/vertex_attributes.glsl"
#define SURFACE_IO out
#include "common/surface_io.glsl"

void main() {
  InstanceData i = instances[draw.ids.x];
  vec3 p = toRelative(i, a_position);
  v_position = p;
  v_normal = normalToWorld(i, a_normal) * i.normal0.w;
  v_tangent = vec4(tangentToWorld(i, a_tangent.xyz), a_tangent.w);
  v_uv = vec4(a_uv0, a_uv1);
  v_color = a_color;
  gl_Position = toClip(frame.viewProjection, p);
}
