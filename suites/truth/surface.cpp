#include "suites/truth/surface.h"

#include "shaders/common/shared_shading.h"
#include "suites/truth/texture_sampler.h"
#include "techniques/scene/material_data.h"

namespace sb {

std::vector<SurfaceTraits> surfaceTraits(const Scene& scene) {
  std::vector<SurfaceTraits> list;
  for (const Material& m : scene.materials) {
    SurfaceTraits traits{.material = materialTraits(scene, m),
                         .packed = materialData(m),
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
      m_weight{1 - hit.b - hit.c, hit.b, hit.c} {
  for (uint32_t c = 0; c < 3; ++c) m_corner[c] = m_mesh.indices[3 * triangle.number + c];
}

template <int N>
glm::vec<N, double> Surface::interpolated(const std::vector<glm::vec<N, float>>& values,
                                          glm::vec<N, double> fallback) const {
  if (values.empty()) return fallback;
  glm::vec<N, double> sum(0);
  for (size_t c = 0; c < 3; ++c) sum += glm::vec<N, double>(values[m_corner[c]]) * m_weight[c];
  return sum;
}

bool Surface::has(uint32_t slot) const { return textureSlot(m_material, slot).present(); }

glm::dvec4 Surface::sample(uint32_t slot) const {
  const TextureSlot& texture = textureSlot(m_material, slot);
  return sampleTexture(m_scene, texture,
                       interpolated<2>(texture.uvSet == 1 ? m_mesh.uv1 : m_mesh.uv0, glm::dvec2(0)));
}

glm::vec4 Surface::baseColor() const {
  glm::vec4 base = m_material.baseColor * glm::vec4(interpolated<4>(m_mesh.colors, glm::dvec4(1)));
  if (has(TEXTURE_BASE_COLOR)) base *= glm::vec4(sample(TEXTURE_BASE_COLOR));
  return base;
}

float Surface::metallic() const {
  const float texel =
      has(TEXTURE_METALLIC_ROUGHNESS) ? float(sample(TEXTURE_METALLIC_ROUGHNESS).b) : 1.0f;
  return m_material.metallic * texel;
}

gpu::OpticsData Surface::optics() const {
  float transmission = m_material.transmission, thickness = m_material.thickness;
  if (has(TEXTURE_TRANSMISSION)) transmission *= float(sample(TEXTURE_TRANSMISSION).r);
  if (has(TEXTURE_THICKNESS)) thickness *= float(sample(TEXTURE_THICKNESS).g);
  return gpu::opticsOf(m_traits.packed, baseColor(), metallic(), transmission, thickness);
}

glm::dvec3 Surface::transmittance() const {
  const gpu::OpticsData o = optics();
  return 1.0 - double(o.alpha) * (1.0 - glm::dvec3(o.t));
}

bool Surface::isEven() const {
  return m_mesh.colors.empty() && !has(TEXTURE_BASE_COLOR) && !has(TEXTURE_METALLIC_ROUGHNESS) &&
         !has(TEXTURE_TRANSMISSION) && !has(TEXTURE_THICKNESS);
}

glm::vec3 Surface::shadingNormal(const glm::vec3& geometric) const {
  const glm::dmat3 linear(m_instance.toWorld);
  const glm::dmat3 cofactor(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                            glm::cross(linear[0], linear[1]));
  const double side = glm::determinant(linear) < 0 ? -1 : 1;
  const glm::dvec3 local = interpolated<3>(m_mesh.normals, glm::dvec3(0, 0, 1));
  glm::vec3 n(glm::normalize(cofactor * local * side));
  if (has(TEXTURE_NORMAL)) {
    glm::vec3 t = glm::vec3(sample(TEXTURE_NORMAL)) * 2.0f - 1.0f;
    t.x *= m_material.normalScale;
    t.y *= m_material.normalScale;
    const glm::dvec4 tangent = interpolated<4>(m_mesh.tangents, glm::dvec4(1, 0, 0, 1));
    const glm::vec3 world(linear * glm::dvec3(tangent));
    glm::vec3 along = world - n * glm::dot(n, world);
    if (const float length2 = glm::dot(along, along); length2 > 0) {
      along *= 1 / std::sqrt(length2);
      const glm::vec3 across = glm::cross(n, along) * float(tangent.w);
      n = glm::normalize(along * t.x + across * t.y + n * t.z);
    }
  }
  return glm::dot(n, geometric) < 0 ? -n : n;
}

glm::vec3 Surface::Response::reflected(const glm::vec3& toLight) const {
  if (unlit) return glm::vec3(0);
  return gpu::reflectedLight(base, metal, roughness, transmission, n, v, toLight);
}

Surface::Response Surface::response(const glm::vec3& position, const glm::vec3& normal) const {
  Response r{.base = glm::vec3(baseColor()),
             .metal = metallic(),
             .roughness = m_material.roughness,
             .transmission = m_material.transmission > 0 ? optics().transmission : 0.0f,
             .n = shadingNormal(normal),
             .v = glm::normalize(-position),
             .unlit = m_material.unlit};
  if (has(TEXTURE_METALLIC_ROUGHNESS)) r.roughness *= float(sample(TEXTURE_METALLIC_ROUGHNESS).g);
  return r;
}

glm::vec3 Surface::ownRadiance(const Response& r, const glm::vec3& ambient) const {
  const float share = gpu::shareReflected(r.metal, r.transmission);
  if (r.unlit) return r.base * share;
  float occlusion = 1;
  if (has(TEXTURE_OCCLUSION))
    occlusion += m_material.occlusionStrength * (float(sample(TEXTURE_OCCLUSION).r) - 1.0f);
  glm::vec3 emissive(m_material.emissive);
  if (has(TEXTURE_EMISSIVE)) emissive *= glm::vec3(sample(TEXTURE_EMISSIVE));

  return emissive + gpu::ambientLight(ambient, m_scene.sky, r.n) * r.base * (occlusion * share);
}

glm::vec3 Surface::shade(const glm::vec3& position, const glm::vec3& normal,
                         const glm::vec3& ambient, std::span<const Arrival> arrivals) const {
  const Response r = response(position, normal);
  glm::vec3 radiance = ownRadiance(r, ambient);
  for (const Arrival& a : arrivals) radiance += r.reflected(a.toLight) * a.radiance;
  return radiance;
}

}  // namespace sb
