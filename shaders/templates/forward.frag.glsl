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
#define SURFACE_IO in
#include "common/surface_io.glsl"
layout(location = 0) out vec4 o_color;

void main() {
  InstanceData i = instances[draw.ids.x];
  MaterialData m = materials[i.ids.x];
  Receiver r = surfaceReceiver(i, v_position);
  vec4 base = baseColorAt(m, v_uv, v_color);
  if (kMasked && base.a < m.emissiveCutoff.w) discard;
  // Nothing passes an opaque surface: metals and black ones reflect the same with transmission.
  o_color = vec4(shadeSurface(m, r, base, 0.0, v_normal, v_tangent, v_uv), 1);
}
