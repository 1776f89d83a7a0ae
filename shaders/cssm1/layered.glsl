// A caster in three layers of a depth map at once, one a channel: three instances, each of which the
// vertex shader sends to its layer.
#extension GL_ARB_shader_viewport_layer_array : require
#include "common/scene.glsl"
#include "common/transform.glsl"
#include "common/light_pass.glsl"

void toLayer(vec3 position) {
  gl_Position = toLightClip(toRelative(instances[draw.ids.x], position));
  gl_Layer = gl_InstanceIndex;
}
