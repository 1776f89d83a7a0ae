// Light on its way through participating media (specs 14 and 16): what passes, and what is
// scattered toward the eye, once. What passes is analytic where density is constant, exact but for
// rounding in grids (Simpson between the planes where their cubic pieces meet), adaptive to 1e-5 in
// smoke. What is scattered is marched: steps weigh a light at their middle by the exact share that
// each medium takes out of the ray, so that the number of steps does not matter in uniform light;
// Richardson's extrapolation over a step and its halves, which are halved again where they disagree
// (media_march.h).
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "techniques/scene/medium_data.h"

namespace sb {

class MediaField {
 public:
  /// Media of no extinction are left out. The scene must outlive the field.
  MediaField(const Scene& scene, const glm::dvec3& eye);

  bool empty() const { return m_boxes.empty(); }

  /// A piece of a ray, relative to the eye.
  struct Stretch {
    glm::dvec3 origin;
    glm::dvec3 direction;     ///< unit
    double from = 0, to = 0;  ///< distances; `to` may be infinite
    glm::dvec3 at(double t) const { return origin + t * direction; }
  };
  /// RGB share of light that passes.
  glm::dvec3 transmittance(const Stretch& stretch) const;

  struct Interval {
    double from, to;
  };
  /// The first piece within boxes; boxes that overlap or touch are one.
  std::optional<Interval> firstInterval(const Stretch& stretch) const;

  /// A light at a point.
  struct Arrival {
    glm::dvec3 toLight;     ///< unit
    glm::dvec3 irradiance;  ///< across the light, without occlusion
    glm::dvec3 visible;     ///< share that arrives
  };
  /// Appends the lights that reach a position relative to the eye.
  using Lights = std::function<void(const glm::dvec3& position, std::vector<Arrival>& out)>;

  struct Passage {
    glm::dvec3 light = glm::dvec3(0);  ///< radiance scattered back along the ray
    glm::dvec3 transmittance = glm::dvec3(1);
  };
  /// To within about a thousandth of what would be scattered if nothing shadowed it; what is lit or
  /// dark over less than a 64th of the way through boxes may be missed.
  Passage pass(const Stretch& stretch, const Lights& lights) const;
  /// The march alone, in about `steps` steps of equal length that end where boxes do: O(h^2).
  Passage march(const Stretch& stretch, const Lights& lights, uint32_t steps) const;

 private:
  friend class MediaMarch;
  struct Box {
    const Medium* medium;
    glm::dmat4 toBox;
    glm::dvec3 extinction, scattering;  ///< of density 1
    gpu::SmokeShape smoke;
  };
  struct Span {
    const Box* box;
    double from, to;
  };
  /// A stretch and where it passes which boxes.
  struct Way {
    const Stretch& stretch;
    std::array<Span, kMaxMedia> spans;
    size_t count = 0;
  };

  Way wayOf(const Stretch& stretch) const;
  /// Density times length within a box, between two distances.
  static double densityOver(const Way& way, const Span& span, double from, double to);
  static glm::dvec3 opticalDepth(const Way& way);

  std::vector<Box> m_boxes;
};

}  // namespace sb
