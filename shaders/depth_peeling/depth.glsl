// The depth of a layer alone, before it is shaded.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
#include "depth_peeling/peel.glsl"
layout(location = 3) in vec4 v_uv;
layout(location = 4) in vec4 v_color;

void main() {
  if (lightOptics(material, v_uv, v_color).alpha <= 0.0) discard;
  discardUnlessNext();
}
