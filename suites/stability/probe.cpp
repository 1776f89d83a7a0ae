#include "suites/stability/probe.h"

#include <algorithm>
#include <cmath>

#include "suites/harness/checks/verify.h"
#include "suites/metrics/exposure.h"

namespace sb {
namespace {

RendererDesc descFor(const CaseContext& context, const ProbeOptions& options) {
  CellId id{.technique = context.technique,
            .transparency = context.transparency,
            .lights = context.lights,
            .width = options.size.width,
            .height = options.size.height,
            .seed = options.seed};
  const auto infos = knobInfosOf(id);
  std::map<std::string, std::string> given = context.knobs;
  for (const auto& [name, value] : options.knobs)
    if (std::ranges::find(infos, name, &KnobInfo::name) != infos.end()) given[name] = value;
  if (std::ranges::find(infos, "size", &KnobInfo::name) != infos.end())
    if (!context.scene) given.try_emplace("size", "256");
  return rendererDesc(withKnobs(std::move(id), given));
}

}  // namespace

bool explained(const Tracer& tracer, uint32_t light, const Tracer::Point& point,
               const LookupReach& reach, const float* value) {
  const Tracer::Range range = tracer.visibilityNear(light, point, reach);
  bool inside = true, varies = false;
  for (int c = 0; c < 3; ++c) {
    inside &= value[c] >= range.low[c] - 1e-3 && value[c] <= range.high[c] + 1e-3;
    varies |= range.high[c] > range.low[c];
  }
  return inside && varies;
}

double cosine(const Scene& scene, uint32_t light, const Tracer::Point& point) {
  const Light& l = scene.lights[light];
  const glm::dvec3 toLight = l.type == LightType::Directional
                                 ? -l.direction
                                 : l.position - scene.camera().eye() - point.position;
  return std::max(0.0, glm::dot(point.normal, glm::normalize(toLight)));
}

Probe::Probe(const CaseContext& context, Scene scene, const ProbeOptions& options)
    : m_scene(std::move(scene)),
      m_options(options),
      m_seeds(context.info().stochastic ? context.seeds : 1) {
  const DeviceContext& device = options.onOther ? *context.other : context.device;
  m_stage.emplace(m_scene, options.size);
  const RendererDesc desc = descFor(context, options);
  if (const auto why = m_stage->unsupported(device.device, desc)) throw Unsupported(why->reason);
  m_renderer = m_stage->renderer(device, desc);
  m_renderer->frame();
}

report::Picture Probe::picture() {
  return {m_options.size.width, m_options.size.height, m_renderer->readImage()};
}

const std::vector<VisibilityImage>& Probe::visibility(uint32_t light) {
  if (light == kFirstInView) light = m_renderer->lights().front();
  auto [it, isNew] = m_visibility.try_emplace(light);
  if (isNew) it->second = m_renderer->readVisibility(light);
  return it->second;
}

glm::dvec3 Probe::meanVisibility(uint32_t layer, uint32_t light) {
  if (light == kFirstInView) light = m_renderer->lights().front();
  glm::dvec3 sum = middleMean(visibility(light)[layer]);
  for (uint32_t i = 1; i < m_seeds; ++i) {
    m_renderer->setSeed(m_options.seed + i);
    m_renderer->frame();
    sum += middleMean(m_renderer->readVisibility(light)[layer]);
  }
  if (m_seeds > 1) {
    m_renderer->setSeed(m_options.seed);
    m_renderer->frame();
  }
  return sum / double(m_seeds);
}

glm::dvec3 Probe::middleMean(const VisibilityImage& image) const {
  const auto [width, height] = m_options.size;
  glm::dvec3 sum(0);
  double count = 0;
  for (uint32_t y = height / 4; y < height * 3 / 4; ++y)
    for (uint32_t x = width / 4; x < width * 3 / 4; ++x) {
      const float* v = image.data() + 4 * (size_t(y) * width + x);
      if (v[3] == 0) continue;
      sum += glm::dvec3(v[0], v[1], v[2]);
      ++count;
    }
  return sum / count;  // not a number where nothing is: no case allows that
}

double pictureDifference(Probe& a, Probe& b) {
  const report::Picture first = a.picture();
  return maxDifference255(first, b.picture(), automaticExposure(first));
}

TruthDifference truthDifference(Probe& probe) {
  const report::Picture picture = probe.picture();
  const Tracer tracer(probe.scene(), picture.width, picture.height);
  const auto truth = tracer.trace({.width = picture.width, .height = picture.height});
  TruthDifference out;
  size_t badlyLit = 0;
  for (const uint32_t light : probe.renderer().lights()) {
    for (uint32_t layer = 0; layer < kTruthLayers; ++layer) {
      const auto& expected = truth->visibility[light * kTruthLayers + layer];
      const auto& edges = truth->edges[light * kTruthLayers + layer];
      const VisibilityImage& image = probe.visibility(light)[layer];
      for (uint32_t p = 0; p < edges.size(); ++p) {
        const float *t = expected.data() + 4 * p, *v = image.data() + 4 * p;
        if (t[3] == 0 || v[3] == 0 || edges[p]) continue;
        Compared values;
        for (size_t c = 0; c < 3; ++c) {
          out.mean += double(v[c]) - double(t[c]);
          values.worst(std::abs(double(v[c]) - double(t[c])));
        }
        out.compared += 3;
        const double worst = values.value();
        if (worst == 0) continue;
        const auto point = tracer.pointAt(p % picture.width, p / picture.width, layer);
        if (!point || explained(tracer, light, *point, probe.renderer().reach(light), v)) continue;
        if (!(worst <= out.worst)) out.worst = worst;  // not a number stays
        const double shaded = worst * cosine(probe.scene(), light, *point);
        badlyLit += shaded <= 0.1 ? 0 : 3;
      }
    }
  }
  // 0 / 0 where nothing was compared, which no tolerance allows.
  out.mean /= double(out.compared);
  out.badlyLitShare = double(badlyLit) / double(out.compared);
  if (out.compared == 0) out.worst = out.mean;
  return out;
}

}  // namespace sb
