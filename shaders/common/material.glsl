// Materials: texture lookups and optics. Textures are sampled at LOD 0 (decision D9).
layout(binding = SLOT_TEXTURE(TEXTURE_MATERIAL + TEXTURE_BASE_COLOR)) uniform sampler2D t_baseColor;
layout(binding = SLOT_TEXTURE(TEXTURE_MATERIAL + TEXTURE_METALLIC_ROUGHNESS)) uniform sampler2D t_metallicRoughness;
layout(binding = SLOT_TEXTURE(TEXTURE_MATERIAL + TEXTURE_NORMAL)) uniform sampler2D t_normal;
layout(binding = SLOT_TEXTURE(TEXTURE_MATERIAL + TEXTURE_OCCLUSION)) uniform sampler2D t_occlusion;
layout(binding = SLOT_TEXTURE(TEXTURE_MATERIAL + TEXTURE_EMISSIVE)) uniform sampler2D t_emissive;
layout(binding = SLOT_TEXTURE(TEXTURE_MATERIAL + TEXTURE_TRANSMISSION)) uniform sampler2D t_transmission;
layout(binding = SLOT_TEXTURE(TEXTURE_MATERIAL + TEXTURE_THICKNESS)) uniform sampler2D t_thickness;

#include "common/shared_optics.h"

bool materialHas(MaterialData m, uint bit) { return (m.flags.x & bit) != 0u; }

bool hasTexture(MaterialData m, uint index) {
  return kTextured && (m.flags.y & (1u << index)) != 0u;
}

vec2 textureUv(MaterialData m, uint index, vec4 uv) {
  vec2 base = (m.flags.z & (1u << index)) != 0u ? uv.zw : uv.xy;
  vec3 h = vec3(base, 1);
  return vec2(dot(m.uvRows[2u * index].xyz, h), dot(m.uvRows[2u * index + 1u].xyz, h));
}

#define SAMPLE_MATERIAL(m, index, map, uv) textureLod(map, textureUv(m, index, uv), 0.0)

vec4 baseColorAt(MaterialData m, vec4 uv, vec4 color) {
  vec4 base = m.baseColor * color;
  if (hasTexture(m, TEXTURE_BASE_COLOR)) base *= SAMPLE_MATERIAL(m, TEXTURE_BASE_COLOR, t_baseColor, uv);
  return base;
}

// Opacity and transmission at a point: what light and camera ask of a surface.
OpticsData opticsAt(MaterialData m, vec4 base, vec4 uv) {
  float metallic = m.surface.x;
  if (materialHas(m, MATERIAL_TRANSMISSION) && hasTexture(m, TEXTURE_METALLIC_ROUGHNESS))
    metallic *= SAMPLE_MATERIAL(m, TEXTURE_METALLIC_ROUGHNESS, t_metallicRoughness, uv).b;
  float transmission = m.transmission.x;
  if (hasTexture(m, TEXTURE_TRANSMISSION))
    transmission *= SAMPLE_MATERIAL(m, TEXTURE_TRANSMISSION, t_transmission, uv).r;
  float thickness = m.transmission.y;
  if (hasTexture(m, TEXTURE_THICKNESS))
    thickness *= SAMPLE_MATERIAL(m, TEXTURE_THICKNESS, t_thickness, uv).g;
  return opticsOf(m, base, metallic, transmission, thickness);
}

OpticsData lightOptics(MaterialData m, vec4 uv, vec4 color) {
  return opticsAt(m, baseColorAt(m, uv, color), uv);
}
