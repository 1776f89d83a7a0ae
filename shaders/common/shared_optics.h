// Optics of a material at a point (decision D8): one definition for C++ and GLSL. The table that
// says what becomes what stands in techniques/scene/optics.h.
#ifndef SHADOWBENCH_SHARED_OPTICS_H
#define SHADOWBENCH_SHARED_OPTICS_H

#ifdef __cplusplus
#include "shaders/common/shared_types.h"
namespace sb::gpu {
using vec3 = glm::vec3;
using glm::clamp;
using glm::pow;
#define SHARED inline
#else
#define SHARED
#endif

struct OpticsData {
  vec3 t;              // light: share of what meets the surface that passes
  float alpha;         // coverage, for light and camera alike
  vec3 behind;         // camera: weight of what lies behind, 1 - alpha (1 - t_camera)
  float transmission;  // share of the diffuse light that passes instead of being reflected
};

// Each of the two boundaries of a closed mesh carries half of the optical depth; thickness 0 is thin.
SHARED vec3 halfOfVolume(MaterialData m, float thickness) {
  if (!(m.transmission.z > 0.0f && thickness > 0.0f)) return vec3(1.0f);
  return pow(vec3(m.attenuation), vec3(0.5f * thickness * m.transmission.z));
}

SHARED OpticsData opticsOf(MaterialData m, vec4 base, float metallic, float transmission,
                           float thickness) {
  OpticsData o;
  vec3 rgb = clamp(vec3(base), 0.0f, 1.0f);
  float a = clamp(base.w, 0.0f, 1.0f);
  bool transmits = (m.flags.x & MATERIAL_TRANSMISSION) != 0u;
  bool blends = (m.flags.x & MATERIAL_BLEND) != 0u;
  o.transmission = transmits ? clamp(transmission, 0.0f, 1.0f) : 0.0f;
  if ((m.flags.x & MATERIAL_OVERRIDE) != 0u) {
    o.alpha = m.overrideOptics.w;
    o.t = vec3(m.overrideOptics);
  } else {
    o.alpha = blends ? a : 1.0f;
    if ((m.flags.x & MATERIAL_MASK) != 0u) o.alpha = a >= m.emissiveCutoff.w ? 1.0f : 0.0f;
    o.t = blends ? 0.5f * rgb : vec3(0.0f);
    // What enters a metal is lost.
    float passes = o.transmission * (1.0f - clamp(metallic, 0.0f, 1.0f));
    if (transmits) o.t = passes * rgb * halfOfVolume(m, thickness);
  }
  // Blended surfaces without transmission hide by their coverage alone.
  o.behind = vec3(1.0f) - o.alpha * (vec3(1.0f) - (transmits ? o.t : vec3(0.0f)));
  return o;
}

#ifdef __cplusplus
#undef SHARED
}  // namespace sb::gpu
#endif

#endif
