// What is at a hit: interpolated attributes, optics and shading, as the shaders compute them
// (shaders/common/material.glsl, surface.glsl).
#pragma once

#include <span>

#include "shaders/common/shared_optics.h"
#include "suites/truth/rays/bvh.h"
#include "techniques/scene/optics.h"
#include "techniques/scene/scene.h"

namespace sb {

/// How a material acts, decided once.
struct SurfaceTraits {
  MaterialTraits material;
  gpu::MaterialData packed;  ///< for the optics that C++ and shaders share
  bool doubleSided = false;
  bool masked = false;
  bool blocks = false;  ///< all light, everywhere
};
std::vector<SurfaceTraits> surfaceTraits(const Scene& scene);

/// A hit with what hangs on it.
class Surface {
 public:
  Surface(const Scene& scene, const std::vector<SurfaceTraits>& traits,
          const TruthTriangle& triangle, const TruthHit& hit);

  const SurfaceTraits& traits() const { return m_traits; }
  /// For light and camera.
  gpu::OpticsData optics() const;
  /// Share of light that passes.
  glm::dvec3 transmittance() const;
  /// Are optics the same everywhere on the mesh?
  bool isEven() const;
  /// Linear, before lighting.
  glm::vec4 baseColor() const;
  /// Factor times texture.
  float metallic() const;

  /// A light's radiance that arrives at the point, and from where.
  struct Arrival {
    glm::vec3 toLight;
    glm::vec3 radiance;  ///< occlusion included
  };
  /// How a surface reflects toward the eye.
  struct Response {
    glm::vec3 base;
    float metal, roughness, transmission;
    glm::vec3 n, v;
    bool unlit;
    /// Of radiance 1 from there, the cosine included.
    glm::vec3 reflected(const glm::vec3& toLight) const;
  };
  /// `normal`: geometric, toward the viewer; `position` relative to the eye.
  Response response(const glm::vec3& position, const glm::vec3& normal) const;
  /// Radiance toward the eye without the lights.
  glm::vec3 ownRadiance(const Response& response, const glm::vec3& ambient) const;
  /// Radiance toward the eye, not yet weighted by coverage.
  glm::vec3 shade(const glm::vec3& position, const glm::vec3& normal, const glm::vec3& ambient,
                  std::span<const Arrival> arrivals) const;

 private:
  /// In double, whatever the attribute is stored in.
  template <int N>
  glm::vec<N, double> interpolated(const std::vector<glm::vec<N, float>>& values,
                                   glm::vec<N, double> fallback) const;
  glm::dvec4 sample(uint32_t slot) const;
  bool has(uint32_t slot) const;
  glm::vec3 shadingNormal(const glm::vec3& geometric) const;

  const Scene& m_scene;
  const Mesh& m_mesh;
  const Instance& m_instance;
  const Material& m_material;
  const SurfaceTraits& m_traits;
  uint32_t m_corner[3];
  double m_weight[3];
};

}  // namespace sb
