#include "suites/harness/judge.h"

#include <algorithm>
#include <cmath>

#include "suites/harness/checks/verify.h"
#include "suites/metrics/error.h"
#include "suites/metrics/error_map.h"
#include "suites/metrics/exposure.h"
#include "suites/metrics/regions.h"
#include "suites/metrics/weighted.h"
#include "suites/truth/truth_cache.h"
#include "techniques/scene/light_area.h"

namespace sb {
namespace {

report::Picture pictureOf(rhi::Extent2D size, const std::vector<float>& rgba) {
  return {size.width, size.height, rgba};
}

void addFile(const std::string& role, const report::Picture& picture,
             std::span<const uint8_t> rgb, report::Record& record, PictureFiles& files) {
  std::string png = report::encodePng(picture.width, picture.height, rgb);
  const std::string hash = report::contentHash(std::as_bytes(std::span(png)));
  record.pictures[role] = hash;
  files[hash] = std::move(png);
}

}  // namespace

Judge::Judge(const Scene& scene, std::string sceneHash, rhi::Extent2D size, JudgeSettings settings)
    : m_scene(scene),
      m_sceneHash(std::move(sceneHash)),
      m_size(size),
      m_settings(std::move(settings)) {
  if (!m_settings.enabled) m_why = "no truth was asked for";
}

const Tracer& Judge::tracer() {
  if (!m_tracer) m_tracer = std::make_unique<Tracer>(m_scene, m_size.width, m_size.height);
  return *m_tracer;
}

const Truth* Judge::truth() {
  if (!m_why.empty() || m_truth) return m_truth ? &*m_truth : nullptr;
  const std::string key = truthKey(m_sceneHash, m_size.width, m_size.height);
  if (!m_settings.cache.empty()) m_truth = readTruth(m_settings.cache, key);
  if (m_truth) return &*m_truth;
  m_truth = tracer().trace({.width = m_size.width,
                            .height = m_size.height,
                            .interrupted = m_settings.interrupted,
                            .progress = m_settings.progress});
  if (!m_truth) {
    m_why = "interrupted";
    return nullptr;
  }
  if (!m_settings.cache.empty()) writeTruth(m_settings.cache, key, *m_truth);
  return &*m_truth;
}

float Judge::exposure(const report::Picture& picture) {
  if (!m_exposure)
    m_exposure = m_settings.exposure ? *m_settings.exposure
                                     : automaticExposure(m_truth ? pictureOf(m_size, m_truth->image)
                                                                 : picture);
  return *m_exposure;
}

Values Judge::truthAt(uint32_t light, uint32_t layer) const {
  return m_truth->visibility[size_t(light) * kTruthLayers + layer];
}

std::span<const uint8_t> Judge::edgesAt(uint32_t light, uint32_t layer) const {
  return m_truth->edges[size_t(light) * kTruthLayers + layer];
}

void Judge::judge(Subject& subject, const CellId& id, const report::Picture& picture,
                  report::Record& record, PictureFiles& files) {
  const bool known = truth() != nullptr;
  const float factor = exposure(picture);
  record.exposure = double(factor);
  if (!known) {
    for (const char* key : {"visibility", "image", "noise", "certificate", "blame", "truth_stderr"})
      record.why[key] = m_why;
    return;
  }
  const report::Picture shown = exposed(picture, factor);
  const report::Picture reference = exposed(pictureOf(m_size, m_truth->image), factor);
  record.image = imageError(shown, reference, m_truth->imageEdges);
  record.truthStderr = m_truth->standardError;
  addFile("image", shown, report::toSrgb8(shown), record, files);
  addFile("truth", shown, report::toSrgb8(reference), record, files);
  addFile("error", shown, errorMap(shown, reference), record, files);

  std::vector<Answer> answers;
  for (const uint32_t light : subject.lights())
    answers.push_back({light, subject.visibility(light, id.seed), subject.reach(light)});
  judgeVisibility(answers, record);
  std::vector<std::vector<SeedMoments>> moments;
  std::string why = subject.whyNotRandom();
  if (why.empty() && m_settings.seeds < 2) why = "one seed alone was asked for";
  if (why.empty())
    moments = judgeSeeds(subject, id.seed, answers, record);
  else
    for (const char* key : {"noise", "certificate"}) record.why[key] = why;
  judgeRegions(answers, moments, record);
  blame(answers, moments, record, files);
}

void Judge::judgeVisibility(const std::vector<Answer>& answers, report::Record& record) const {
  ErrorSum all, interior;
  report::VisibilityError total;
  WeightedSum weighted, weightedInterior;
  for (const Answer& a : answers)
    for (uint32_t layer = 0; layer < kTruthLayers; ++layer) {
      const Values measured = a.layers[layer], expected = truthAt(a.light, layer);
      const auto edges = edgesAt(a.light, layer);
      report::LayerError error{.light = a.light,
                               .lightName = m_scene.lights[a.light].name,
                               .layer = layer,
                               .error = {errorOf(measured, expected),
                                         errorOf(measured, expected, edges)}};
      error.error.oneSided = oneSided(measured, m_truth->surfaces[layer]);
      error.error.oneSidedInterior = oneSided(measured, m_truth->surfaces[layer], edges);
      total.oneSided += error.error.oneSided;
      total.oneSidedInterior += error.error.oneSidedInterior;
      if (error.error.all.pixels == 0 && error.error.oneSided == 0) continue;
      all.add(measured, expected);
      interior.add(measured, expected, edges);
      const auto& reflected = m_truth->reflected[size_t(a.light) * kTruthLayers + layer];
      weighted.add(measured, expected, reflected);
      weightedInterior.add(measured, expected, reflected, edges);
      record.visibilityLayers.push_back(std::move(error));
    }
  total.all = all.stats();
  total.interior = interior.stats();
  total.weighted = weighted.rmse();
  total.weightedInterior = weightedInterior.rmse();
  if (total.oneSidedInterior > 0)
    record.warnings.push_back(std::to_string(total.oneSidedInterior) +
                              " pixels away from edges show a surface to the technique or to the "
                              "truth alone: they are in no error");
  if (total.all.pixels > 0)
    record.visibility = total;
  else
    record.why["visibility"] = "no lit surface is in the picture";
}

void Judge::judgeRegions(const std::vector<Answer>& answers,
                         const std::vector<std::vector<SeedMoments>>& moments,
                         report::Record& record) const {
  RegionSum sum;
  for (size_t i = 0; i < answers.size(); ++i) {
    const std::vector<float> variance =
        moments.empty() ? std::vector<float>() : moments[i][0].variance();
    sum.add(answers[i].layers[0], truthAt(answers[i].light, 0), edgesAt(answers[i].light, 0),
            variance);
  }
  record.visibilityRegions = sum.regions();
}

ValueRange Judge::truthAround(uint32_t light, uint32_t layer, uint32_t x, uint32_t y,
                              const LookupReach& reach) {
  // At silhouettes the rasteriser's pixel may show a neighbour's surface.
  constexpr uint32_t kPixels = 2;
  const Values truth = truthAt(light, layer);
  ValueRange range{{1, 1, 1}, {0, 0, 0}};
  auto add = [&](size_t channel, double low, double high) {
    range.low[channel] = std::min(range.low[channel], float(low));
    range.high[channel] = std::max(range.high[channel], float(high));
  };
  for (uint32_t j = y - std::min(y, kPixels); j <= std::min(y + kPixels, m_size.height - 1); ++j)
    for (uint32_t i = x - std::min(x, kPixels); i <= std::min(x + kPixels, m_size.width - 1); ++i) {
      const float* v = truth.data() + 4 * (size_t(j) * m_size.width + i);
      for (size_t c = 0; c < 3 && v[3] == 1; ++c) add(c, double(v[c]), double(v[c]));
    }
  if (const auto point = tracer().pointAt(x, y, layer)) {
    const Tracer::Range near = tracer().visibilityNear(light, *point, reach);
    for (size_t c = 0; c < 3; ++c) add(c, near.low[int(c)], near.high[int(c)]);
  }
  return range;
}

void Judge::blame(const std::vector<Answer>& answers,
                  const std::vector<std::vector<SeedMoments>>& moments, report::Record& record,
                  PictureFiles& files) {
  BlameSum sum(m_size.width, m_size.height);
  for (size_t i = 0; i < answers.size(); ++i) {
    const Answer& a = answers[i];
    const bool looksUp = a.reach.constant > 0 || a.reach.perDistance > 0;
    for (uint32_t layer = 0; layer < kTruthLayers; ++layer) {
      const std::vector<float> variance =
          moments.empty() ? std::vector<float>() : moments[i][layer].variance();
      BlameInput input{.measured = a.layers[layer],
                       .truth = truthAt(a.light, layer),
                       .mean = moments.empty() ? Values() : Values(moments[i][layer].mean()),
                       .variance = variance,
                       .seeds = moments.empty() ? 1 : moments[i][layer].seeds(),
                       .surfaces = m_truth->surfaces[layer],
                       .areaLight = isAreaLight(m_scene.lights[a.light]),
                       .truthAround = nullptr};
      if (looksUp)
        input.truthAround = [&](uint32_t x, uint32_t y) {
          return truthAround(a.light, layer, x, y, a.reach);
        };
      sum.add(input);
    }
  }
  record.blame = sum.blame();
  if (record.blame->shares.empty()) return;
  addFile("blame", pictureOf(m_size, {}), sum.picture(), record, files);
}

}  // namespace sb
