// The depth of a layer of the visibility buffer alone, for techniques that answer by layers.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
#include "common/visibility_layer.glsl"
layout(location = 3) in vec4 v_uv;
layout(location = 4) in vec4 v_color;

void main() {
  discardUnlessInLayer(lightOptics(material, v_uv, v_color).alpha);
}
