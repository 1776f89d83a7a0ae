// What is random apart from what is wrong: the same cell with other seeds.
#include <cmath>

#include "reports/stats/regression.h"
#include "suites/harness/checks/certify.h"
#include "suites/harness/judge.h"
#include "suites/metrics/error.h"

namespace sb {

std::vector<std::vector<SeedMoments>> Judge::judgeSeeds(Subject& subject, uint32_t seed,
                                                        const std::vector<Answer>& answers,
                                                        report::Record& record) {
  std::vector<TrialRegion> regions;
  const uint32_t trials = answers.empty() ? 0 : answers.front().reach.trials;
  for (const Answer& a : answers)
    for (uint32_t layer = 0; layer < kTruthLayers; ++layer)
      for (TrialRegion& r : trialRegions(tracer(), truthAt(a.light, layer), edgesAt(a.light, layer),
                                         m_size, a.light, layer, a.reach))
        regions.push_back(std::move(r));

  std::vector<std::vector<SeedMoments>> moments(answers.size(),
                                                std::vector<SeedMoments>(kTruthLayers));
  std::vector<double> errors, biases;
  for (uint32_t n = 0; n < m_settings.seeds; ++n) {
    if (m_settings.interrupted && m_settings.interrupted->load()) break;
    if (m_settings.progress) m_settings.progress(double(n) / m_settings.seeds);
    ErrorSum sum;
    for (size_t i = 0; i < answers.size(); ++i) {
      const auto layers = subject.visibility(answers[i].light, seed + n);
      for (uint32_t layer = 0; layer < kTruthLayers; ++layer) {
        moments[i][layer].add(layers[layer]);
        sum.add(layers[layer], truthAt(answers[i].light, layer));
      }
      for (TrialRegion& r : regions)
        if (r.light == answers[i].light) addSeed(r, layers[r.layer], trials);
    }
    const report::ErrorStats stats = sum.stats();
    errors.push_back(stats.rmse);
    biases.push_back(stats.bias);
  }

  record.noise = noiseOf(answers, moments);
  const report::Interval interval = report::medianInterval(errors);
  record.noise->rmseLow = interval.low;
  record.noise->rmseHigh = interval.high;
  const report::Interval bias = report::meanInterval(biases);
  record.noise->biasLow = bias.low;
  record.noise->biasHigh = bias.high;
  record.certificate = certificateOf(regions, m_size);
  return moments;
}

report::NoiseRecord Judge::noiseOf(const std::vector<Answer>& answers,
                                   const std::vector<std::vector<SeedMoments>>& moments) const {
  ErrorSum mean;
  double variance = 0;
  uint64_t values = 0;
  for (size_t i = 0; i < answers.size(); ++i)
    for (uint32_t layer = 0; layer < kTruthLayers; ++layer) {
      const Values expected = truthAt(answers[i].light, layer);
      const SeedMoments& m = moments[i][layer];
      mean.add(m.mean(), expected);
      const std::vector<float> v = m.variance();
      for (size_t p = 0; p + 3 < v.size(); p += 4) {
        if (m.mean()[p + 3] != 1 || expected[p + 3] != 1) continue;
        for (size_t c = 0; c < 3; ++c) variance += double(v[p + c]);
        values += 3;
      }
    }
  const report::ErrorStats bias = mean.stats();
  const uint32_t seeds = answers.empty() ? 0 : moments[0][0].seeds();
  if (values) variance /= double(values);
  // E[(mean - truth)^2] = bias^2 + variance / seeds.
  const double ofMean = seeds ? variance / seeds : 0;
  return {.seeds = seeds,
          .noise = std::sqrt(variance),
          .biasRmse = std::sqrt(std::max(0.0, bias.rmse * bias.rmse - ofMean)),
          .bias = bias.bias};
}

}  // namespace sb
