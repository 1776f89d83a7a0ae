// From a receiver to the radiance that it sends to the camera: normal, material, direct light. The
// including shader has defined lightVisibility(light, receiver), the shadow technique's answer, and
// the loop of the light technique; a technique that integrates visibility with reflection (spec 11,
// DIRECT) defines REPLACES_DIRECT_LIGHT beside its answer, and directLight as below.
#include "common/shared_shading.h"

// Shading normal: interpolated, bent by the normal map, turned to the viewer's side (spec 16).
vec3 shadingNormal(MaterialData m, Receiver r, vec3 normal, vec4 tangent, vec4 uv) {
  vec3 n = normalize(normal);
  if (kNormalMaps && hasTexture(m, TEXTURE_NORMAL)) {
    vec3 t = SAMPLE_MATERIAL(m, TEXTURE_NORMAL, t_normal, uv).xyz * 2.0 - 1.0;
    t.xy *= m.surface.z;
    vec3 along = tangent.xyz - n * dot(n, tangent.xyz);
    float length2 = dot(along, along);
    if (length2 > 0.0) {
      along *= inversesqrt(length2);
      vec3 across = cross(n, along) * tangent.w;
      n = normalize(along * t.x + across * t.y + n * t.z);
    }
  }
  return dot(n, r.normal) < 0.0 ? -n : n;
}

#ifndef REPLACES_DIRECT_LIGHT
// Radiance toward the camera of one light, reflected (spec 16, V-mode).
vec3 directLight(uint light, Receiver r, Reflector s) {
  Illumination i = illumination(lightAt(light), r.position);
  // The geometric normal decides sides: no light through a surface, and no lookup for none.
  if (dot(r.normal, i.toLight) <= 0.0 || all(lessThanEqual(i.radiance, vec3(0)))) return vec3(0);
  vec3 reflected = reflectedLight(s.albedo, s.metallic, s.roughness, s.transmission, s.normal,
                                  s.toEye, i.toLight) * i.radiance;
  if (all(lessThanEqual(reflected, vec3(0)))) return vec3(0);
  return reflected * lightVisibility(light, r);
}
#endif

// Radiance toward the camera from a point of a surface, of which the diffuse part passes by
// `transmission`.
vec3 shadeSurface(MaterialData m, Receiver r, vec4 base, float transmission, vec3 normal,
                  vec4 tangent, vec4 uv) {
  float metallic = m.surface.x, roughness = m.surface.y, occlusion = 1.0;
  if (hasTexture(m, TEXTURE_METALLIC_ROUGHNESS)) {
    vec4 mr = SAMPLE_MATERIAL(m, TEXTURE_METALLIC_ROUGHNESS, t_metallicRoughness, uv);
    roughness *= mr.g;
    metallic *= mr.b;
  }
  float share = shareReflected(metallic, transmission);
  if (materialHas(m, MATERIAL_UNLIT)) return base.rgb * share;
  if (hasTexture(m, TEXTURE_OCCLUSION))
    occlusion += m.surface.w * (SAMPLE_MATERIAL(m, TEXTURE_OCCLUSION, t_occlusion, uv).r - 1.0);
  vec3 emissive = m.emissiveCutoff.rgb;
  if (hasTexture(m, TEXTURE_EMISSIVE)) emissive *= SAMPLE_MATERIAL(m, TEXTURE_EMISSIVE, t_emissive, uv).rgb;

  vec3 n = shadingNormal(m, r, normal, tangent, uv);
  Reflector s = Reflector(base.rgb, metallic, roughness, transmission, n, normalize(-r.position));
  vec3 radiance = emissive + ambientLight(frame.ambient.rgb, frame.sky.rgb, n) * base.rgb *
                                 (occlusion * share);
  LightLoop loop = beginLights(r);
  while (nextLight(loop)) radiance += directLight(loop.light, r, s);
  return radiance;
}
