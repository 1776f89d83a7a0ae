#include "suites/truth/surface.h"

#include "shaders/common/shared_shading.h"
#include "suites/truth/texture_sampler.h"
#include "techniques/common/material_data.h"

namespace sb {

std::vector<SurfaceTraits> surfaceTraits(const Scene& scene) {
  std::vector<SurfaceTraits> list;
  for (const Material& m : scene.materials) {
    SurfaceTraits traits{.material = materialTraits(scene, m),
                         .data = materialData(m),
                         .doubleSided = m.doubleSided,
                         .masked = m.alphaMode == AlphaMode::Mask};
    traits.blocks = traits.material.lightClass == MaterialClass::Opaque;
    list.push_back(traits);
  }
  return list;
}

Surface::Surface(const Scene& scene, const std::vector<SurfaceTraits>& traits,
                 const TruthTriangle& triangle, const TruthHit& hit)
    : m_scene(scene),
      m_mesh(scene.meshes[scene.instances[triangle.instance].mesh]),
      m_instance(scene.instances[triangle.instance]),
      m_material(scene.materials[m_mesh.material]),
      m_traits(traits[m_mesh.material]),
      m_weight{float(1 - hit.b - hit.c), float(hit.b), float(hit.c)} {
  for (uint32_t c = 0; c < 3; ++c) m_corner[c] = m_mesh.indices[3 * triangle.number + c];
}

template <class T>
T Surface::interpolated(const std::vector<T>& values, T fallback) const {
  if (values.empty()) return fallback;
  return values[m_corner[0]] * m_weight[0] + values[m_corner[1]] * m_weight[1] +
         values[m_corner[2]] * m_weight[2];
}

bool Surface::has(uint32_t slot) const { return textureSlot(m_material, slot).present(); }

glm::dvec4 Surface::sample(uint32_t slot) const {
  const TextureSlot& texture = textureSlot(m_material, slot);
  return sampleTexture(m_scene, texture,
                       interpolated(texture.uvSet == 1 ? m_mesh.uv1 : m_mesh.uv0, glm::vec2(0)));
}

glm::vec4 Surface::baseColor() const {
  glm::vec4 base = m_traits.data.baseColor * interpolated(m_mesh.colors, glm::vec4(1));
  if (has(TEXTURE_BASE_COLOR)) base *= glm::vec4(sample(TEXTURE_BASE_COLOR));
  return base;
}

gpu::OpticsData Surface::optics() const {
  float transmission = m_traits.data.transmission.x, thickness = m_traits.data.transmission.y;
  if (has(TEXTURE_TRANSMISSION)) transmission *= float(sample(TEXTURE_TRANSMISSION).r);
  if (has(TEXTURE_THICKNESS)) thickness *= float(sample(TEXTURE_THICKNESS).g);
  return gpu::opticsOf(m_traits.data, baseColor(), transmission, thickness);
}

glm::vec3 Surface::shadingNormal(const glm::vec3& geometric) const {
  const glm::dmat3 linear(m_instance.toWorld);
  const glm::dmat3 cofactor(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                            glm::cross(linear[0], linear[1]));
  const double side = glm::determinant(linear) < 0 ? -1 : 1;
  const glm::vec3 local = interpolated(m_mesh.normals, glm::vec3(0, 0, 1));
  glm::vec3 n(glm::normalize(cofactor * glm::dvec3(local) * side));
  if (has(TEXTURE_NORMAL)) {
    glm::vec3 t = glm::vec3(sample(TEXTURE_NORMAL)) * 2.0f - 1.0f;
    t.x *= m_traits.data.surface.z;
    t.y *= m_traits.data.surface.z;
    const glm::vec4 tangent = interpolated(m_mesh.tangents, glm::vec4(1, 0, 0, 1));
    const glm::vec3 world(linear * glm::dvec3(glm::vec3(tangent)));
    glm::vec3 along = world - n * glm::dot(n, world);
    if (const float length2 = glm::dot(along, along); length2 > 0) {
      along *= 1 / std::sqrt(length2);
      const glm::vec3 across = glm::cross(n, along) * tangent.w;
      n = glm::normalize(along * t.x + across * t.y + n * t.z);
    }
  }
  return glm::dot(n, geometric) < 0 ? -n : n;
}

glm::vec3 Surface::shade(const glm::vec3& position, const glm::vec3& normal,
                         const glm::vec3& ambient, std::span<const Arrival> arrivals) const {
  const glm::vec3 base(baseColor());
  const gpu::MaterialData& m = m_traits.data;
  if ((m.flags.x & MATERIAL_UNLIT) != 0) return base;
  float metallic = m.surface.x, roughness = m.surface.y, occlusion = 1;
  if (has(TEXTURE_METALLIC_ROUGHNESS)) {
    const glm::vec4 mr(sample(TEXTURE_METALLIC_ROUGHNESS));
    roughness *= mr.g;
    metallic *= mr.b;
  }
  if (has(TEXTURE_OCCLUSION))
    occlusion += m.surface.w * (float(sample(TEXTURE_OCCLUSION).r) - 1.0f);
  glm::vec3 emissive(m.emissiveCutoff);
  if (has(TEXTURE_EMISSIVE)) emissive *= glm::vec3(sample(TEXTURE_EMISSIVE));

  const glm::vec3 n = shadingNormal(normal), v = glm::normalize(-position);
  glm::vec3 radiance = emissive + gpu::ambientLight(ambient, m_scene.sky, n) * base * occlusion;
  for (const Arrival& a : arrivals)
    radiance += gpu::reflectedLight(base, metallic, roughness, n, v, a.toLight) * a.radiance;
  return radiance;
}

}  // namespace sb
