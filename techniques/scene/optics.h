// How a material becomes opacity and transmission (decision D8): the one place that says so.
//   light:  a shadow ray that meets the surface keeps tau = 1 - alpha (1 - t) per channel
//   camera: what lies behind keeps `behind` per channel, and the surface adds
//           alpha (diffuse (1 - transmission) + specular)
#pragma once

#include <glm/glm.hpp>

#include "techniques/scene/scene.h"

namespace sb {

struct Optics {
  float alpha = 1;                        ///< coverage that light and camera meet, [0,1]
  glm::vec3 transmission = glm::vec3(0);  ///< t: share of met light that passes, [0,1]^3
  glm::vec3 behind = glm::vec3(0);        ///< weight of what the camera sees behind, [0,1]^3
};

/// A material at a point: factors times textures (times vertex colours), linear.
struct OpticsPoint {
  glm::vec4 baseColor = glm::vec4(1);
  float metallic = 0;
  float transmission = 0;
  float thickness = 0;  ///< world units
};

/// Defined once, for C++ and shaders, in shaders/common/shared_optics.h.
///   OPAQUE                        alpha 1, t 0
///   MASK                          alpha 1 if a >= cutoff else 0, t 0
///   BLEND                         alpha a, t 0.5 x rgb (Modisett 2023, section 4.2.1); the camera's t is
///                                 0, so that it sees 1 - a of what lies behind
///   KHR_materials_transmission    t = transmission x rgb x (1 - metallic), for the camera too; alpha
///                                 stays what the mode makes it: coverage
///   KHR_materials_volume          t times attenuationColor ^ (thickness / 2 attenuationDistance):
///                                 a closed mesh is crossed at two boundaries, half of it at each
///   extras.shadowbench alpha, t   stated outright; the camera's t is this one only with
///                                 KHR_materials_transmission
Optics optics(const Material& material, const OpticsPoint& point);

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
  /// What the camera sees behind weighs more than 1 - alpha somewhere: glass.
  bool cameraColoured = false;
};
MaterialTraits materialTraits(const Scene& scene, const Material& material);

}  // namespace sb
