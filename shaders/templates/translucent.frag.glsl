#version 450
// Translucent surfaces, lit through the technique's visibility and handed to the transparency
// technique. Its emit.glsl defines
//   bool beginFragment(float alpha)                 before shading: discards, or returns false when
//                                                   the fragment needs no shading
//   void emitFragment(vec3 radiance, float alpha)   radiance is not multiplied by alpha yet
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/transform.glsl"
#include "common/material.glsl"
#include "common/receiver.glsl"
#include <technique/visibility.glsl>
#include "common/surface.glsl"
#define SURFACE_IO in
#include "common/surface_io.glsl"
#include <transparency/emit.glsl>

void main() {
  InstanceData i = instances[draw.ids.x];
  MaterialData m = materials[i.ids.x];
  Receiver r = surfaceReceiver(i, v_position);
  vec4 base = baseColorAt(m, v_uv, v_color);
  float alpha = opticsAt(m, base, v_uv).cameraAlpha;
  // A layer that does not exist takes no part (spec 15).
  if (alpha <= 0.0) discard;
  if (!beginFragment(alpha)) return;
  emitFragment(shadeSurface(m, r, base, v_normal, v_tangent, v_uv), alpha);
}
