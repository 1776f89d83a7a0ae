// One position of the picture after the other: the layers there, their visibility, their colour.
#pragma once

#include "suites/truth/lights/light_visibility.h"
#include "suites/truth/media/media_view.h"

namespace sb {

class Sampler {
 public:
  Sampler(const RayScene& scene, const LightVisibility& lights)
      : m_scene(scene), m_lights(lights), m_media(scene, lights) {}

  /// Finds the layers at a position, in pixels.
  void find(double x, double y, const AreaSampling& sampling);
  /// Each at its position; cheaper if those that follow one another are neighbours.
  static void find(std::span<Sampler> samplers, std::span<const glm::dvec2> positions,
                   const AreaSampling& sampling);

  struct Layer {
    Tracer::Point point;
    std::vector<uint8_t> asked;  ///< per light: its radiance reaches the side that is seen
    std::vector<LightVisibility::Answer> answers;  ///< per light; visible 1 where it is not asked
  };
  /// Front to back; the last one is opaque if endsOpaque().
  std::span<const Layer> layers() const { return {m_layers.data(), m_found.hits.size()}; }
  bool endsOpaque() const { return m_found.endsOpaque; }
  /// Luminance that a light would send to the eye from a layer if nothing shadowed it.
  float reflected(size_t layer, uint32_t light) const;
  /// Composited from back to front.
  glm::vec3 color();
  const MediaView& media() const { return m_media; }
  uint64_t rays() const { return m_rays + m_media.rays(); }

 private:
  void beginLayers(double x, double y);
  /// Radiance toward the eye from a layer.
  glm::vec3 shade(size_t layer);

  const RayScene& m_scene;
  const LightVisibility& m_lights;
  MediaView m_media;
  RayScene::CameraHits m_found;
  std::vector<Layer> m_layers;  ///< those of m_found; more are kept for later positions
  LightVisibility::Scratch m_scratch;
  AreaSampling m_sampling;
  uint64_t m_rays = 0;
};

/// Everything of a truth; the caller has entered the arena to work in.
std::optional<Truth> traceTruth(const RayScene& scene, const LightVisibility& lights,
                                const TruthSettings& settings);

}  // namespace sb
