#include "suites/metrics/noise.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sb {

void SeedMoments::add(Values values) {
  if (m_seeds == 0) {
    m_mean.assign(values.begin(), values.end());
    m_squares.assign(values.size(), 0.0f);
  } else if (values.size() != m_mean.size()) {
    throw std::invalid_argument("seeds differ in size");
  }
  ++m_seeds;
  if (m_seeds == 1) return;
  for (size_t i = 0; i < values.size(); ++i) {
    if (i % 4 == 3) continue;
    const double before = values[i] - double(m_mean[i]);
    const double mean = m_mean[i] + before / m_seeds;
    m_squares[i] = float(m_squares[i] + before * (values[i] - mean));
    m_mean[i] = float(mean);
  }
}

std::vector<float> SeedMoments::variance() const {
  std::vector<float> v(m_squares.size(), 0.0f);
  if (m_seeds < 2) return v;
  for (size_t i = 0; i < v.size(); ++i) v[i] = m_squares[i] / float(m_seeds - 1);
  return v;
}

namespace {

double logBinomial(uint64_t k, uint64_t n, double q) {
  const double x = double(k), m = double(n);
  return std::lgamma(m + 1) - std::lgamma(x + 1) - std::lgamma(m - x + 1) + x * std::log(q) +
         (m - x) * std::log1p(-q);
}

/// Sum of the probabilities from `k` outward, away from the mode: up (k, k+1, ...) or down.
double tail(uint64_t k, uint64_t n, double q, bool up) {
  double term = std::exp(logBinomial(k, n, q)), sum = 0;
  const double odds = q / (1 - q);
  while (term > 0) {
    sum += term;
    if (term < sum * 1e-17) break;
    if (up) {
      if (k == n) break;
      term *= double(n - k) / double(k + 1) * odds;
      ++k;
    } else {
      if (k == 0) break;
      term *= double(k) / double(n - k + 1) / odds;
      --k;
    }
  }
  return sum;
}

}  // namespace

double binomialPValue(uint64_t passes, uint64_t trials, double q) {
  if (passes > trials || !(q >= 0 && q <= 1)) throw std::invalid_argument("no such binomial");
  if (trials == 0) return 1;
  if (q == 0) return passes == 0 ? 1 : 0;
  if (q == 1) return passes == trials ? 1 : 0;
  const uint64_t mode = std::min(trials, uint64_t(double(trials + 1) * q));
  // Outcomes within rounding of the one seen are as likely as it.
  const double seen = logBinomial(passes, trials, q) + 1e-7;
  if (logBinomial(mode, trials, q) <= seen) return 1;
  const bool upper = passes > mode;
  // The nearest outcome on the other side that is no likelier: probabilities fall from the mode.
  uint64_t likelier = mode, end = upper ? 0 : trials;
  double p = tail(passes, trials, q, upper);
  if (logBinomial(end, trials, q) > seen) return p;
  while (likelier > end + 1 || end > likelier + 1) {
    const uint64_t middle = upper ? end + (likelier - end) / 2 : likelier + (end - likelier) / 2;
    (logBinomial(middle, trials, q) > seen ? likelier : end) = middle;
  }
  p += tail(end, trials, q, !upper);
  return std::min(1.0, p);
}

void judge(report::Certificate& certificate) {
  const double least = certificate.familyWiseError / double(std::max<size_t>(1, certificate.regions.size()));
  certificate.unbiased = std::ranges::none_of(
      certificate.regions, [&](const report::RegionTest& r) { return r.pValue < least; });
}

std::vector<std::vector<uint32_t>> uniformRegions(Values truth, std::span<const uint8_t> mask,
                                                  uint32_t width, uint32_t height, uint32_t least) {
  std::vector<std::vector<uint32_t>> regions;
  std::vector<uint8_t> seen(size_t(width) * height, 0);
  auto alike = [&](uint32_t a, uint32_t b) {
    for (size_t c = 0; c < 3; ++c)
      if (std::abs(truth[4 * size_t(a) + c] - truth[4 * size_t(b) + c]) > 1e-6f) return false;
    return true;
  };
  auto open = [&](uint32_t p) {
    return !seen[p] && truth[4 * size_t(p) + 3] == 1 && (mask.empty() || mask[p] == 0);
  };
  std::vector<uint32_t> stack;
  for (uint32_t first = 0; first < width * height; ++first) {
    if (!open(first)) continue;
    std::vector<uint32_t> region;
    stack = {first};
    seen[first] = 1;
    while (!stack.empty()) {
      const uint32_t p = stack.back();
      stack.pop_back();
      region.push_back(p);
      const uint32_t x = p % width, y = p / width;
      auto visit = [&](uint32_t q) {
        // All are compared with the first pixel, so that a gradient is no region.
        if (!open(q) || !alike(first, q)) return;
        seen[q] = 1;
        stack.push_back(q);
      };
      if (x > 0) visit(p - 1);
      if (x + 1 < width) visit(p + 1);
      if (y > 0) visit(p - width);
      if (y + 1 < height) visit(p + width);
    }
    if (region.size() < least) continue;
    std::ranges::sort(region);
    regions.push_back(std::move(region));
  }
  return regions;
}

}  // namespace sb
