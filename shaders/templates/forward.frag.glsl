#version 450
// Opaque and perforated surfaces, lit through the technique's visibility.
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/transform.glsl"
#include "common/material.glsl"
#include "common/receiver.glsl"
#include <technique/visibility.glsl>
#include <lights/lights.glsl>
#include "common/surface.glsl"
#include "common/shading.glsl"
layout(location = 0) out vec4 o_color;

void main() {
  Receiver r = surfaceReceiver(v_position);
  vec4 base = baseColorAt(material, v_uv, v_color);
  if (kMasked && base.a < material.emissiveCutoff.w) discard;
  // Nothing passes an opaque surface: metals and black ones reflect the same with transmission.
  o_color = vec4(shadeSurface(material, r, base, 0.0, v_normal, v_tangent, v_uv), 1);
}
