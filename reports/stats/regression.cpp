// Student's t by its finite series for whole degrees of freedom (Abramowitz and Stegun 1964,
// 26.7.3 and 26.7.4), inverted by bisection: exact to the last digits for every count of points.
#include "reports/stats/regression.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace report {
namespace {

/// P(|T| <= t).
double withinT(double t, uint32_t freedom) {
  const double angle = std::atan(t / std::sqrt(double(freedom)));
  const double cosine = std::cos(angle), sine = std::sin(angle);
  const bool odd = freedom % 2 == 1;
  double sum = 0, term = odd ? cosine : 1;
  for (uint32_t k = odd ? 3 : 2; k <= freedom; k += 2) {
    sum += term;
    term *= cosine * cosine * double(k - 1) / double(k);
  }
  return odd ? 2 / std::numbers::pi * (angle + sine * sum) : sine * sum;
}

}  // namespace

double studentQuantile(uint32_t freedom) {
  assert(freedom > 0);
  // 12.7 at one degree of freedom is the largest.
  double low = 0, high = 16;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (withinT(middle, freedom) < 0.95 ? low : high) = middle;
  }
  return high;
}

Interval meanInterval(std::span<const double> samples) {
  if (samples.size() < 2) return samples.empty() ? Interval{} : Interval{samples[0], samples[0]};
  const double n = double(samples.size());
  double mean = 0, squares = 0;
  for (const double s : samples) mean += s / n;
  for (const double s : samples) squares += (s - mean) * (s - mean);
  const double half =
      studentQuantile(uint32_t(samples.size() - 1)) * std::sqrt(squares / (n * (n - 1)));
  return {mean - half, mean + half};
}

Slope fitSlope(std::span<const std::pair<double, double>> points) {
  assert(points.size() >= 3);
  const double n = double(points.size());
  double meanX = 0, meanY = 0;
  for (const auto& [x, y] : points) {
    meanX += x / n;
    meanY += y / n;
  }
  double xx = 0, xy = 0;
  for (const auto& [x, y] : points) {
    xx += (x - meanX) * (x - meanX);
    xy += (x - meanX) * (y - meanY);
  }
  assert(xx > 0);
  const double slope = xy / xx;
  double residuals = 0;
  for (const auto& [x, y] : points) {
    const double residual = y - meanY - slope * (x - meanX);
    residuals += residual * residual;
  }
  const double half =
      studentQuantile(uint32_t(points.size() - 2)) * std::sqrt(residuals / (n - 2) / xx);
  return {slope, {slope - half, slope + half}};
}

}  // namespace report
