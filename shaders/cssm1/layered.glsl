// A caster in three layers of a depth map at once, one a channel: three instances, each of which the
// vertex shader sends to its layer.
#extension GL_ARB_shader_viewport_layer_array : require
#include "common/scene.glsl"
#include "common/light_pass.glsl"
#include "common/instance.glsl"
layout(location = 10) in uvec4 a_order;  // y: which of the three

void toLayer(vec3 position) {
  gl_Position = toLightClip(placeInstance(position));
  gl_Layer = int(a_order.y);
}
