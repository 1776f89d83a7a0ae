// How a material becomes opacity and transmission (decision D8): the one place that says so.
//   light:  a shadow ray that meets the surface keeps tau = 1 - alpha (1 - t) per channel
//   camera: a view ray composites the surface's shaded colour with weight `cameraAlpha`
#pragma once

#include <glm/glm.hpp>

#include "techniques/common/scene.h"

namespace sb {

struct Optics {
  float alpha = 1;                          ///< coverage that light meets, [0,1]
  glm::vec3 transmission = glm::vec3(0);    ///< t: share of met light that passes, [0,1]^3
  float cameraAlpha = 1;                    ///< coverage that the camera composites, [0,1]
};

/// Optics of `material` where its base colour (factor x texture x vertex colour, linear) is
/// `baseColor`, its transmission (factor x texture) `transmission` and its thickness (factor x
/// texture, world units) `thickness`. Defined once, for C++ and shaders, in
/// shaders/common/shared_optics.h.
///   OPAQUE                        alpha 1, t 0
///   MASK                          alpha 1 if a >= cutoff else 0, t 0
///   BLEND                         alpha a, t 0.5 x rgb (seed 000, section 4.2.1)
///   KHR_materials_transmission    t = transmission x rgb, alpha 1 for the light (times the mask),
///                                 1 - transmission for the camera
///   KHR_materials_volume          t times attenuationColor ^ (thickness / attenuationDistance)
///   extras.shadowbench alpha, t   stated outright, for the camera too
Optics optics(const Material& material, glm::vec4 baseColor, float transmission, float thickness);

/// How a material can act on light, decided without looking at texels where they do not matter.
enum class MaterialClass : uint8_t {
  Opaque,       ///< blocks all light
  Perforated,   ///< alpha mask: each point blocks all or nothing
  Translucent,  ///< lets some light through
};
/// Translucent materials that are in fact opaque (alpha 1, t 0 everywhere) are classed Opaque.
/// Vertex colours count as variation.
struct MaterialTraits {
  MaterialClass lightClass = MaterialClass::Opaque;
  bool cameraTranslucent = false;  ///< the camera sees through it somewhere
  bool textured = false;           ///< alpha or t vary over the surface (texture)
  bool coloured = false;           ///< t differs between channels somewhere
};
MaterialTraits materialTraits(const Scene& scene, const Material& material);

}  // namespace sb
