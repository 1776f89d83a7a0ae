#version 450
// Translucent surfaces, lit through the technique's visibility and handed to the transparency
// technique. Its emit.glsl defines
//   bool beginFragment(float alpha)                 before shading: discards, or returns false when
//                                                   the fragment needs no shading
//   void emitFragment(vec3 radiance, float alpha)   radiance is not multiplied by alpha yet
// or, for scenes with glass (Effect::ColouredTransparency), EMITS_WEIGHTS and
//   bool beginFragment(OpticsData optics)
//   void emitFragment(vec3 light, vec3 behind)      what the surface adds, and the weight of what
//                                                   lies behind in each channel
#include "common/options.glsl"
#include "common/scene.glsl"
#include "common/transform.glsl"
#include "common/material.glsl"
#include "common/receiver.glsl"
#include <technique/visibility.glsl>
#include <lights/lights.glsl>
#include "common/surface.glsl"
#include "common/shading.glsl"
#include <transparency/emit.glsl>

void main() {
  Receiver r = surfaceReceiver(v_position);
  vec4 base = baseColorAt(material, v_uv, v_color);
  OpticsData optics = opticsAt(material, base, v_uv);
  // A layer that does not exist takes no part (spec 15).
  if (optics.alpha <= 0.0) discard;
#ifdef EMITS_WEIGHTS
  if (!beginFragment(optics)) return;
  vec3 radiance = shadeSurface(material, r, base, optics.transmission, v_normal, v_tangent, v_uv);
  emitFragment(optics.alpha * radiance, optics.behind);
#else
  if (!beginFragment(optics.alpha)) return;
  emitFragment(shadeSurface(material, r, base, 0.0, v_normal, v_tangent, v_uv), optics.alpha);
#endif
}
