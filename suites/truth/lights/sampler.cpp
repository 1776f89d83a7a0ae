#include "suites/truth/lights/sampler.h"

namespace sb {

void Sampler::find(double x, double y, const AreaSampling& sampling) {
  const glm::dvec2 position(x, y);
  find(std::span(this, 1), std::span(&position, 1), sampling);
}

void Sampler::beginLayers(double x, double y) {
  if (m_layers.size() < m_found.hits.size()) m_layers.resize(m_found.hits.size());
  for (size_t i = 0; i < m_found.hits.size(); ++i) {
    Layer& layer = m_layers[i];
    layer.point = m_scene.point(x, y, m_found.hits[i]);
    layer.asked.assign(m_scene.lights(), 0);
    layer.answers.assign(m_scene.lights(), {});
    for (uint32_t l = 0; l < m_scene.lights(); ++l)
      layer.asked[l] = m_scene.reaches(l, layer.point);
  }
}

void Sampler::find(std::span<Sampler> samplers, std::span<const glm::dvec2> positions,
                   const AreaSampling& sampling) {
  Sampler& first = samplers.front();
  std::vector<RayScene::CameraHits*> found;
  for (Sampler& s : samplers) found.push_back(&s.m_found);
  first.m_scene.cameraHits(positions, found);
  size_t most = 0;
  for (size_t i = 0; i < samplers.size(); ++i) {
    Sampler& s = samplers[i];
    s.m_sampling = sampling;
    s.beginLayers(positions[i].x, positions[i].y);
    ++s.m_rays;
    most = std::max(most, s.layers().size());
  }
  std::vector<LightVisibility::Query> queries;
  for (uint32_t light = 0; light < first.m_scene.lights(); ++light)
    for (size_t layer = 0; layer < most; ++layer) {
      queries.clear();
      for (Sampler& s : samplers)
        if (layer < s.layers().size() && s.m_layers[layer].asked[light])
          queries.push_back({&s.m_layers[layer].point, &s.m_layers[layer].answers[light]});
      first.m_lights.ask(light, queries, sampling, first.m_scratch);
      for (const LightVisibility::Query& q : queries) first.m_rays += q.answer->rays;
    }
  for (size_t i = 0; i < samplers.size(); ++i)
    samplers[i].m_media.find(positions[i].x, positions[i].y, samplers[i].m_found, sampling);
}

float Sampler::reflected(size_t layer, uint32_t light) const {
  const Tracer::Point& point = m_layers[layer].point;
  const gpu::Illumination i = m_scene.illumination(light, point);
  const Surface surface = m_scene.surface(m_found.hits[layer]);
  const Surface::Response response =
      surface.response(glm::vec3(point.position), glm::vec3(point.normal));
  const glm::vec3 own = surface.ownRadiance(response, glm::vec3(0));
  const glm::vec3 radiance = own + response.reflected(i.toLight) * i.radiance - own;
  return std::max(0.0f, glm::dot(radiance, glm::vec3(0.2126f, 0.7152f, 0.0722f)));
}

glm::vec3 Sampler::shade(size_t index) {
  const Layer& layer = m_layers[index];
  const glm::vec3 position(layer.point.position), normal(layer.point.normal);
  const Surface surface = m_scene.surface(m_found.hits[index]);
  std::vector<Surface::Arrival> arrivals;
  glm::vec3 integrated(0);
  for (uint32_t l = 0; l < m_scene.lights(); ++l) {
    if (m_sampling.integrated && m_lights.isArea(l)) {
      const Surface::Response response = surface.response(position, normal);
      const auto answer = m_lights.integrate(
          l, layer.point,
          [&](const glm::dvec3& toLight) {
            return glm::dvec3(response.reflected(glm::vec3(toLight)));
          },
          m_sampling, m_scratch);
      integrated += glm::vec3(answer.visible);
      m_rays += answer.rays;
    } else if (layer.asked[l]) {
      const gpu::Illumination light = m_scene.illumination(l, layer.point);
      arrivals.push_back({light.toLight, light.radiance * glm::vec3(layer.answers[l].visible)});
    }
  }
  return surface.shade(position, normal, m_scene.scene().ambient, arrivals) + integrated;
}

glm::vec3 Sampler::color() {
  glm::vec3 color = m_scene.scene().background;
  if (!m_found.endsOpaque) color = m_media.through(layers().size(), color);
  for (size_t i = layers().size(); i-- > 0;) {
    const glm::vec3 radiance = shade(i);
    if (m_found.endsOpaque && i + 1 == layers().size()) {
      color = radiance;
    } else {
      const gpu::OpticsData optics = m_scene.surface(m_found.hits[i]).optics();
      color = color * optics.behind + radiance * optics.alpha;
    }
    color = m_media.through(i, color);
  }
  return color;
}

}  // namespace sb
