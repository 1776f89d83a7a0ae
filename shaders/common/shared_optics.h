// Optics of a material at a point (decision D8): one definition for C++ and GLSL. The table that
// says what becomes what stands in techniques/common/optics.h.
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
  vec3 t;             // transmission colour
  float alpha;        // coverage for light
  float cameraAlpha;  // coverage for the camera
};

SHARED OpticsData opticsOf(MaterialData m, vec4 base, float transmission, float thickness) {
  OpticsData o;
  vec3 rgb = clamp(vec3(base), 0.0f, 1.0f);
  float a = clamp(base.w, 0.0f, 1.0f);
  float mask = (m.flags.x & MATERIAL_MASK) != 0u ? (a >= m.emissiveCutoff.w ? 1.0f : 0.0f) : 1.0f;
  if ((m.flags.x & MATERIAL_OVERRIDE) != 0u) {
    o.alpha = m.overrideOptics.w;
    o.t = vec3(m.overrideOptics);
    o.cameraAlpha = o.alpha;
    return o;
  }
  o.alpha = mask;
  o.cameraAlpha = mask;
  o.t = vec3(0.0f);
  if ((m.flags.x & MATERIAL_TRANSMISSION) != 0u) {
    vec3 absorbed = vec3(1.0f);
    if (m.transmission.z > 0.0f && thickness > 0.0f)
      absorbed = pow(vec3(m.attenuation), vec3(thickness * m.transmission.z));
    float passes = clamp(transmission, 0.0f, 1.0f);
    o.t = passes * rgb * absorbed;
    o.cameraAlpha = mask * (1.0f - passes);
  } else if ((m.flags.x & MATERIAL_BLEND) != 0u) {
    o.alpha = a;
    o.cameraAlpha = a;
    o.t = 0.5f * rgb;
  }
  return o;
}

#ifdef __cplusplus
#undef SHARED
}  // namespace sb::gpu
#endif

#endif
