#include "reports/stats/stats.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>

namespace report {

double quantile(std::vector<double> samples, double q) {
  if (samples.empty()) return 0;
  std::ranges::sort(samples);
  const double position = q * double(samples.size() - 1);
  const size_t low = size_t(position);
  const size_t high = std::min(low + 1, samples.size() - 1);
  return samples[low] + (samples[high] - samples[low]) * (position - double(low));
}

double median(std::span<const double> samples) {
  return quantile({samples.begin(), samples.end()}, 0.5);
}

Distribution distribution(std::span<const double> samples) {
  Distribution d;
  d.n = uint32_t(samples.size());
  if (samples.empty()) return d;
  const std::vector<double> copy(samples.begin(), samples.end());
  d.median = quantile(copy, 0.5);
  d.q1 = quantile(copy, 0.25);
  d.q3 = quantile(copy, 0.75);
  double mean = 0, squares = 0;
  for (double s : samples) mean += s / double(samples.size());
  for (double s : samples) squares += (s - mean) * (s - mean);
  if (samples.size() > 1 && mean > 0)
    d.cv = std::sqrt(squares / double(samples.size() - 1)) / mean;
  return d;
}

Interval medianInterval(std::span<const double> samples) {
  std::vector<double> sorted(samples.begin(), samples.end());
  std::ranges::sort(sorted);
  const size_t n = sorted.size();
  if (n == 0) return {};
  // Largest k with P(Binomial(n, 1/2) < k) <= 0.025: ranks k and n + 1 - k bound the median.
  double term = std::pow(0.5, double(n)), sum = 0;
  size_t k = 0;
  while (k < n / 2 && sum + term <= 0.025) {
    sum += term;
    term *= double(n - k) / double(k + 1);
    ++k;
  }
  const size_t rank = k == 0 ? 0 : k - 1;
  return {sorted[rank], sorted[n - 1 - rank]};
}

Ratio pairedRatio(std::span<const double> a, std::span<const double> b) {
  assert(a.size() == b.size());
  Ratio result;
  result.n = uint32_t(a.size());
  if (a.empty()) return result;
  std::vector<double> ratios;
  for (size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i] / b[i]);
  result.value = median(ratios);
  std::mt19937 random(20220101);
  std::vector<double> medians, resample(ratios.size());
  for (int i = 0; i < 2000; ++i) {
    // Modulo bias is below 1e-7 for these sizes, and the draw is the same on every standard library.
    for (double& r : resample) r = ratios[random() % ratios.size()];
    medians.push_back(median(resample));
  }
  result.low = quantile(medians, 0.025);
  result.high = quantile(medians, 0.975);
  return result;
}

}  // namespace report
