#include "suites/truth/media/media_view.h"

#include <limits>

namespace sb {
namespace {

/// Of lights with an extent at each of the many points along a ray, whose mean counts.
constexpr AreaSampling kAlongRay = {.first = 64, .most = 1024, .error = 5e-3};

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A point on no surface.
Tracer::Point inSpace(const glm::dvec3& position) {
  return {.position = position,
          .normal = glm::dvec3(0),
          .instance = kNone,
          .triangle = kNone,
          .translucent = false};
}

}  // namespace

void MediaView::find(double x, double y, const RayScene::CameraHits& found,
                     const AreaSampling& sampling) {
  m_x = x, m_y = y, m_found = &found;
  m_sampling = sampling.pattern > 0 ? sampling : kAlongRay;
  if (m_scene.media().empty()) return;
  m_point.asked.assign(m_scene.lights(), 0);
  m_point.answers.assign(m_scene.lights(), {});
  const MediaField::Stretch stretch =
      m_scene.cameraStretch(x, y, 0, found.endsOpaque ? found.hits.back().t : kInfinity);
  const auto first = m_scene.media().firstInterval(stretch);
  if (!first) return;
  const Tracer::Point at = inSpace(stretch.at(0.5 * (first->from + first->to)));
  for (uint32_t l = 0; l < m_scene.lights(); ++l) {
    if (m_scene.illumination(l, at).radiance == glm::vec3(0)) continue;
    m_point.asked[l] = 1;
    m_point.answers[l] = m_lights.ask(l, at, sampling, m_scratch);
    m_rays += m_point.answers[l].rays;
  }
}

void MediaView::lightsAt(const glm::dvec3& position, std::vector<MediaField::Arrival>& out) {
  const Tracer::Point at = inSpace(position);
  for (uint32_t l = 0; l < m_scene.lights(); ++l) {
    const glm::vec3 irradiance = m_scene.illumination(l, at).radiance;
    if (irradiance == glm::vec3(0)) continue;
    const auto answer = m_lights.ask(l, at, m_sampling, m_scratch);
    out.push_back({.toLight = m_scene.toLight(l, position),
                   .irradiance = glm::dvec3(irradiance),
                   .visible = answer.visible});
    m_rays += answer.rays;
  }
}

glm::vec3 MediaView::through(size_t i, const glm::vec3& behind) {
  if (m_scene.media().empty()) return behind;
  const auto& hits = m_found->hits;
  const MediaField::Passage passage = m_scene.media().pass(
      m_scene.cameraStretch(m_x, m_y, i == 0 ? 0 : hits[i - 1].t,
                            i < hits.size() ? hits[i].t : kInfinity),
      [this](const glm::dvec3& position, std::vector<MediaField::Arrival>& out) {
        lightsAt(position, out);
      });
  return glm::vec3(passage.light + passage.transmittance * glm::dvec3(behind));
}

}  // namespace sb
