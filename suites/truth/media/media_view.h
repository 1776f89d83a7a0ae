// The media that one camera ray passes between the surfaces that it meets.
#pragma once

#include "suites/truth/lights/light_visibility.h"

namespace sb {

class MediaView {
 public:
  MediaView(const RayScene& scene, const LightVisibility& lights)
      : m_scene(scene), m_lights(lights) {}

  /// Turns to a position in the picture, in pixels. `found` must stand until the next.
  void find(double x, double y, const RayScene::CameraHits& found, const AreaSampling& sampling);

  /// Where visibility within media is asked for, once a pixel: the middle of the ray's first piece
  /// within boxes (those that overlap or touch are one), from the eye to the first opaque surface.
  /// It depends on boxes and depth alone, so that techniques find it too.
  struct Point {
    std::vector<uint8_t> asked;                    ///< per light: its radiance reaches the point
    std::vector<LightVisibility::Answer> answers;  ///< per light; 1 where it is not asked
  };
  /// Of scenes with media: nothing is asked where the ray meets none.
  const Point& point() const { return m_point; }

  /// What arrives at the near end of piece `i`, which ends at surface i (the last one never), of
  /// the radiance at its far end. The eye's near and far planes do not cut media.
  glm::vec3 through(size_t i, const glm::vec3& behind);
  uint64_t rays() const { return m_rays; }

 private:
  void lightsAt(const glm::dvec3& position, std::vector<MediaField::Arrival>& out);

  const RayScene& m_scene;
  const LightVisibility& m_lights;
  const RayScene::CameraHits* m_found = nullptr;
  double m_x = 0, m_y = 0;
  Point m_point;
  AreaSampling m_sampling;  ///< of points along the ray
  LightVisibility::Scratch m_scratch;
  uint64_t m_rays = 0;
};

}  // namespace sb
