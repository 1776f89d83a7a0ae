#version 450
// What passes a translucent surface: 1 - alpha (1 - t), multiplied into the map.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
layout(location = 3) in vec4 v_uv;
layout(location = 4) in vec4 v_color;
layout(location = 0) out vec4 o_colour;

void main() {
  OpticsData o = lightOptics(material, v_uv, v_color);
  if (o.alpha < 1.0 / 512.0) discard;
  o_colour = vec4(vec3(1) - o.alpha * (vec3(1) - o.t), 1);
}
