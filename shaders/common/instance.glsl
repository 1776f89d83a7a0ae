// The instance at hand, in vertex shaders: parts of InstanceData as attributes that advance once an
// instance, so that one draw call serves many instances and no binding changes between them.
#include "common/transform.glsl"
layout(location = 6) in vec4 a_toRelative0;
layout(location = 7) in vec4 a_toRelative1;
layout(location = 8) in vec4 a_toRelative2;
layout(location = 9) in uvec4 a_ids;
layout(location = 5) flat out uvec4 v_ids;

// Camera-relative world. Every vertex shader of the scene calls it once.
vec3 placeInstance(vec3 p) {
  v_ids = a_ids;
  return toRelative(a_toRelative0, a_toRelative1, a_toRelative2, p);
}
