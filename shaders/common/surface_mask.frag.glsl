#version 450
// Depth of perforated surfaces as the camera sees them: discards where the alpha mask says so.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/material.glsl"
layout(location = 3) in vec4 v_uv;
layout(location = 4) in vec4 v_color;

void main() {
  if (baseColorAt(material, v_uv, v_color).a < material.emissiveCutoff.w) discard;
}
