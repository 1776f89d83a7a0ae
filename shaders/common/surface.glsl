// From interpolated attributes to a shaded surface: receiver, optics, direct light. The including
// shader has defined lightVisibility(light, receiver), the technique's answer.
#include "common/instance_ids.glsl"
#define SURFACE_IO in
#include "common/surface_io.glsl"
#include "common/shared_hash.h"
#include "common/shared_shading.h"

layout(binding = SLOT_STORAGE(STORAGE_TRIANGLE_ORDER), std430) readonly buffer TriangleOrderBlock {
  uint triangleOrder[];
};

// Number of the triangle at hand in its mesh.
#define HAS_TRIANGLE_ORDER
uint currentTriangleIndex() {
  uint index = uint(gl_PrimitiveID);
  // Triangles sorted one by one come through a list of their numbers.
  return kTriangleOrder ? triangleOrder[v_firstOrdered + index] : index;
}

TriangleData currentTriangle() {
  return triangles[INSTANCE_FIRST_TRIANGLE + currentTriangleIndex()];
}

// Persistent key of the surface at hand (decision D2).
uint currentSurfaceKey() {
  return surfaceKey(INSTANCE_MESH_KEY, INSTANCE_KEY, floatBitsToUint(currentTriangle().normalKey.w));
}

Receiver surfaceReceiver(vec3 position) {
  Receiver r;
  r.position = position;
  r.dpdx = dFdx(position);
  r.dpdy = dFdy(position);
  TriangleData t = currentTriangle();
  vec3 n = throughRows(v_normalRow0, v_normalRow1, v_normalRow2, t.normalKey.xyz);
  n = n * inversesqrt(max(dot(n, n), 1e-38));
  r.normal = dot(n, position) > 0.0 ? -n : n;
  r.instance = INSTANCE;
  r.mesh = INSTANCE_MESH_KEY;
  r.key = surfaceKey(INSTANCE_MESH_KEY, INSTANCE_KEY, floatBitsToUint(t.normalKey.w));
  r.pixel = uvec2(gl_FragCoord.xy);
  r.kind = RECEIVER_SURFACE;
  r.concave = concaveSides(t);
  // As the normal was turned.
  if (dot(n, position) > 0.0) r.concave = (r.concave >> 1) | ((r.concave & 1u) << 1);
  return r;
}

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
  vec3 v = normalize(-r.position);
  vec3 radiance = emissive + ambientLight(frame.ambient.rgb, frame.sky.rgb, n) * base.rgb *
                                 (occlusion * share);
  for (uint light = 0u; light < frame.counts.x; ++light) {
    Illumination i = illumination(lightAt(light), r.position);
    // The geometric normal decides sides: no light through a surface, and no lookup for none.
    if (dot(r.normal, i.toLight) <= 0.0 || all(lessThanEqual(i.radiance, vec3(0)))) continue;
    vec3 reflected = reflectedLight(base.rgb, metallic, roughness, transmission, n, v, i.toLight) * i.radiance;
    if (all(lessThanEqual(reflected, vec3(0)))) continue;
    radiance += reflected * lightVisibility(light, r);
  }
  return radiance;
}
