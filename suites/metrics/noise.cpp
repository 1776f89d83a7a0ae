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
