#include "reports/stats/stats.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>

namespace report {
namespace {

/// Rank from either end (from 0) of the order statistics that bound the median at 95 %: with k the
/// largest number for which P(Binomial(n, 1/2) < k) <= 0.025, the k-th; 0 where there is none.
size_t medianRank(size_t n) {
  const double half = double(n) / 2;
  // Twelve standard deviations below the middle the tail is below 1e-30: nothing is lost there,
  // and the sum stays short. In logarithms, since 0.5^n is no double from n = 1075 on.
  const size_t first = size_t(std::max(0.0, std::floor(half - 6 * std::sqrt(double(n)) - 1)));
  double term = std::lgamma(double(n) + 1) - std::lgamma(double(first) + 1) -
                std::lgamma(double(n - first) + 1) - double(n) * std::log(2.0);
  double sum = 0;
  size_t k = first;
  while (k < n / 2 && sum + std::exp(term) <= 0.025) {
    sum += std::exp(term);
    term += std::log(double(n - k)) - std::log(double(k + 1));
    ++k;
  }
  return k == 0 ? 0 : k - 1;
}

/// Of at least one sample, which is reordered.
double medianInPlace(std::vector<double>& samples) {
  const auto middle = samples.begin() + ptrdiff_t(samples.size() / 2);
  std::ranges::nth_element(samples, middle);
  if (samples.size() % 2) return *middle;
  return (*std::max_element(samples.begin(), middle) + *middle) / 2;
}

}  // namespace

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
  d.p95 = quantile(copy, 0.95);
  d.p99 = quantile(copy, 0.99);
  double mean = 0, squares = 0;
  for (double s : samples) mean += s / double(samples.size());
  for (double s : samples) squares += (s - mean) * (s - mean);
  if (samples.size() > 1 && mean > 0)
    d.cv = std::sqrt(squares / double(samples.size() - 1)) / mean;
  return d;
}

Interval medianInterval(std::span<const double> samples) {
  if (samples.empty()) return {};
  std::vector<double> sorted(samples.begin(), samples.end());
  std::ranges::sort(sorted);
  const size_t rank = medianRank(sorted.size());
  return {sorted[rank], sorted[sorted.size() - 1 - rank]};
}

Ratio pairedRatio(std::span<const double> a, std::span<const double> b) {
  assert(a.size() == b.size());
  Ratio result;
  result.n = uint32_t(a.size());
  if (a.empty()) return result;
  result.value = median(a) / median(b);
  std::mt19937 random(20220101);
  std::vector<double> ratios, x(a.size()), y(a.size());
  for (int i = 0; i < 2000; ++i) {
    for (size_t k = 0; k < a.size(); ++k) {
      // Modulo bias is below 1e-7 for these sizes, and the draw is the same on every standard
      // library.
      const size_t pair = random() % a.size();
      x[k] = a[pair];
      y[k] = b[pair];
    }
    ratios.push_back(medianInPlace(x) / medianInPlace(y));
  }
  result.low = quantile(ratios, 0.025);
  result.high = quantile(ratios, 0.975);
  return result;
}

}  // namespace report
