#include "suites/truth/sampler.h"


namespace sb {

void Sampler::find(double x, double y) {
  m_scene.cameraHits(x, y, m_found);
  ++m_rays;
  m_layers.clear();
  for (const TruthHit& hit : m_found.hits) {
    Layer& layer = m_layers.emplace_back();
    layer.point = m_scene.point(x, y, hit);
    layer.asked.assign(m_scene.lights(), 0);
    layer.visible.assign(m_scene.lights(), glm::dvec3(1));
    for (uint32_t l = 0; l < m_scene.lights(); ++l) {
      if (!m_scene.reaches(l, layer.point)) continue;
      layer.asked[l] = 1;
      layer.visible[l] = m_scene.visibility(l, layer.point, m_scratch);
      ++m_rays;
    }
  }
  m_media.find(x, y, m_found);
}

float Sampler::reflected(size_t layer, uint32_t light) const {
  const Tracer::Point& point = m_layers[layer].point;
  const gpu::Illumination i = m_scene.illumination(light, point);
  const Surface::Arrival arrival{i.toLight, i.radiance};
  const Surface surface = m_scene.surface(m_found.hits[layer]);
  const auto shaded = [&](std::span<const Surface::Arrival> arrivals) {
    return surface.shade(glm::vec3(point.position), glm::vec3(point.normal), glm::vec3(0),
                         arrivals);
  };
  const glm::vec3 radiance = shaded(std::span(&arrival, 1)) - shaded({});
  return std::max(0.0f, glm::dot(radiance, glm::vec3(0.2126f, 0.7152f, 0.0722f)));
}

glm::vec3 Sampler::color() {
  glm::vec3 color = m_scene.scene().background;
  if (!m_found.endsOpaque) color = m_media.through(m_layers.size(), color);
  std::vector<Surface::Arrival> arrivals;
  for (size_t i = m_layers.size(); i-- > 0;) {
    const Layer& layer = m_layers[i];
    arrivals.clear();
    for (uint32_t l = 0; l < m_scene.lights(); ++l) {
      if (!layer.asked[l]) continue;
      const gpu::Illumination light = m_scene.illumination(l, layer.point);
      arrivals.push_back({light.toLight, light.radiance * glm::vec3(layer.visible[l])});
    }
    const Surface surface = m_scene.surface(m_found.hits[i]);
    const glm::vec3 radiance =
        surface.shade(glm::vec3(layer.point.position), glm::vec3(layer.point.normal),
                      m_scene.scene().ambient, arrivals);
    const bool opaque = m_found.endsOpaque && i + 1 == m_layers.size();
    if (opaque) {
      color = radiance;
    } else {
      const gpu::OpticsData optics = surface.optics();
      color = color * optics.behind + radiance * optics.alpha;
    }
    color = m_media.through(i, color);
  }
  return color;
}

}  // namespace sb
