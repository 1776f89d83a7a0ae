#include "suites/metrics/regions.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sb {

std::string_view regionName(Region region) {
  constexpr std::array<std::string_view, kRegions> kNames = {"dark", "saturated", "pale", "lit"};
  return kNames[size_t(region)];
}

Region regionOf(const float* rgb) {
  const auto [low, high] = std::minmax({rgb[0], rgb[1], rgb[2]});
  if (high <= 0.05f) return Region::Dark;
  if (high - low > 0.5f * high) return Region::Saturated;
  return low >= 1 - 1.0f / 255 ? Region::Lit : Region::Pale;
}

void RegionSum::add(Values measured, Values truth, std::span<const uint8_t> mask, Values variance) {
  if (measured.size() != truth.size() || (!mask.empty() && mask.size() * 4 != truth.size()) ||
      (!variance.empty() && variance.size() != truth.size()))
    throw std::invalid_argument("pictures to compare differ in size");
  m_noise |= !variance.empty();
  for (size_t p = 0; 4 * p + 3 < truth.size(); ++p) {
    if (measured[4 * p + 3] != 1 || truth[4 * p + 3] != 1 || (!mask.empty() && mask[p])) continue;
    Sum& sum = m_sums[size_t(regionOf(&truth[4 * p]))];
    ++sum.pixels;
    for (size_t c = 0; c < 3; ++c) {
      const double e = double(measured[4 * p + c]) - double(truth[4 * p + c]);
      sum.squares += e * e;
      sum.errors += e;
      if (!variance.empty()) sum.variance += double(variance[4 * p + c]);
    }
  }
}

std::vector<report::RegionError> RegionSum::regions() const {
  uint64_t all = 0;
  for (const Sum& s : m_sums) all += s.pixels;
  std::vector<report::RegionError> out;
  for (size_t i = 0; i < kRegions; ++i) {
    const Sum& s = m_sums[i];
    if (s.pixels == 0) continue;
    const double values = 3 * double(s.pixels);
    out.push_back({.region = std::string(regionName(Region(i))),
                   .share = double(s.pixels) / double(all),
                   .rmse = std::sqrt(s.squares / values),
                   .bias = s.errors / values,
                   .noise = {}});
    if (m_noise) out.back().noise = std::sqrt(s.variance / values);
  }
  return out;
}

}  // namespace sb
