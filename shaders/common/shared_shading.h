// The shading twin (decision D9): direct light of one metallic-roughness surface, one definition for
// GLSL and for the truth in C++. GGX distribution, height-correlated Smith visibility, Schlick's
// Fresnel, Lambert's diffuse: glTF 2.0, appendix B.
#ifndef SHADOWBENCH_SHARED_SHADING_H
#define SHADOWBENCH_SHARED_SHADING_H

#ifdef __cplusplus
#include "shaders/common/shared_types.h"
namespace sb::gpu {
using vec3 = glm::vec3;
using glm::clamp;
using glm::dot;
using glm::max;
using glm::min;
using glm::mix;
using glm::normalize;
using glm::sqrt;
#define SHARED inline
#else
#define SHARED
#endif

// Reflected share of the light from direction `l` toward `v` around normal `n` (all unit vectors),
// the cosine included; multiply by radiance times visibility. `transmission`: of the diffuse light,
// the share that passes instead.
SHARED vec3 reflectedLight(vec3 albedo, float metallic, float roughness, float transmission, vec3 n,
                           vec3 v, vec3 l) {
  float nl = dot(n, l);
  if (nl <= 0.0f) return vec3(0.0f);
  float nv = max(dot(n, v), 1e-4f);
  vec3 h = normalize(l + v);
  float nh = clamp(dot(n, h), 0.0f, 1.0f);
  float vh = clamp(dot(v, h), 0.0f, 1.0f);
  float a = max(roughness * roughness, 1e-3f);
  float a2 = a * a;
  float q = nh * nh * (a2 - 1.0f) + 1.0f;
  float distribution = a2 / (3.14159265f * q * q);
  float visibility = 0.5f / (nl * sqrt(nv * nv * (1.0f - a2) + a2) + nv * sqrt(nl * nl * (1.0f - a2) + a2));
  vec3 f0 = mix(vec3(0.04f), albedo, metallic);
  float k = 1.0f - vh;
  float k2 = k * k;
  vec3 fresnel = f0 + (vec3(1.0f) - f0) * (k2 * k2 * k);
  vec3 diffuse = albedo * ((1.0f - metallic) * (1.0f - transmission) * (1.0f / 3.14159265f));
  return ((vec3(1.0f) - fresnel) * diffuse + fresnel * (distribution * visibility)) * nl;
}

// Share of its colour that a surface shows of light from everywhere, and of itself when it is unlit:
// transmission takes from what is not metal.
SHARED float shareReflected(float metallic, float transmission) {
  return 1.0f - transmission * (1.0f - clamp(metallic, 0.0f, 1.0f));
}

// Ambient radiance that reaches a surface with normal `n`: the same from everywhere, and the sky's
// from above (Scene::sky).
SHARED vec3 ambientLight(vec3 ambient, vec3 sky, vec3 n) {
  return ambient + sky * (0.5f + 0.5f * n.y);
}

// What a light sends to a camera-relative point: `toLight` unit, radiance without occlusion.
struct Illumination {
  vec3 toLight;
  vec3 radiance;
};

SHARED Illumination illumination(LightData light, vec3 p) {
  Illumination i;
  if (light.ids.x == LIGHT_DIRECTIONAL) {
    i.toLight = -vec3(light.directionScale);
    i.radiance = vec3(light.colorOffset);
    return i;
  }
  vec3 d = vec3(light.positionRange) - p;
  float d2 = dot(d, d);
  i.toLight = d / sqrt(max(d2, 1e-30f));
  // KHR_lights_punctual: inverse square, windowed by the range.
  float w2 = d2 * light.positionRange.w * light.positionRange.w;
  float window = clamp(1.0f - w2 * w2, 0.0f, 1.0f);
  float attenuation = window / max(d2, 1e-30f);
  if (light.ids.x == LIGHT_SPOT) {
    float spot = clamp(dot(vec3(light.directionScale), -i.toLight) * light.directionScale.w +
                           light.colorOffset.w, 0.0f, 1.0f);
    attenuation *= spot * spot;
  }
  i.radiance = vec3(light.colorOffset) * attenuation;
  return i;
}

#ifdef __cplusplus
#undef SHARED
}  // namespace sb::gpu
#endif

#endif
