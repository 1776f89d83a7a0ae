#include "suites/metrics/error.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "suites/metrics/flip.h"

namespace sb {
namespace {

constexpr double kRelativeFloor = 0.01;  ///< of relMSE: dark pixels do not decide it

bool counts(Values measured, Values truth, std::span<const uint8_t> mask, size_t pixel) {
  return measured[4 * pixel + 3] == 1 && truth[4 * pixel + 3] == 1 &&
         (mask.empty() || mask[pixel] == 0);
}

void requireAlike(Values measured, Values truth, std::span<const uint8_t> mask) {
  if (measured.size() != truth.size() || measured.size() % 4 != 0 ||
      (!mask.empty() && mask.size() * 4 != measured.size()))
    throw std::invalid_argument("pictures to compare differ in size");
}

/// Relative to the truth, over pixels whose mask is 0.
double relativeError(Values measured, Values truth, std::span<const uint8_t> mask) {
  double sum = 0;
  uint64_t values = 0;
  for (size_t p = 0; 4 * p < measured.size(); ++p) {
    if (!counts(measured, truth, mask, p)) continue;
    for (size_t c = 0; c < 3; ++c) {
      const double t = truth[4 * p + c], e = measured[4 * p + c] - t;
      sum += e * e / (t * t + kRelativeFloor);
      ++values;
    }
  }
  return values ? sum / double(values) : 0;
}

double meanOf(std::span<const float> values, std::span<const uint8_t> mask) {
  double sum = 0;
  uint64_t count = 0;
  for (size_t p = 0; p < values.size(); ++p)
    if (mask.empty() || mask[p] == 0) sum += values[p], ++count;
  return count ? sum / double(count) : 0;
}

}  // namespace

void ErrorSum::add(Values measured, Values truth, std::span<const uint8_t> mask) {
  requireAlike(measured, truth, mask);
  for (size_t p = 0; 4 * p < measured.size(); ++p) {
    if (!counts(measured, truth, mask, p)) continue;
    for (size_t c = 0; c < 3; ++c) {
      const float e = measured[4 * p + c] - truth[4 * p + c];
      if (!std::isfinite(e)) throw std::invalid_argument("a value to compare is not finite");
      m_differences.push_back(e);
    }
  }
}

report::ErrorStats ErrorSum::stats() const {
  report::ErrorStats s;
  const size_t pixels = m_differences.size() / 3;
  if (pixels == 0) return s;
  double squares[3] = {}, sums[3] = {};
  std::vector<float> largest(pixels);
  uint64_t over = 0;
  for (size_t p = 0; p < pixels; ++p) {
    for (size_t c = 0; c < 3; ++c) {
      const double e = m_differences[3 * p + c];
      squares[c] += e * e;
      sums[c] += e;
      largest[p] = std::max(largest[p], float(std::abs(e)));
    }
    over += largest[p] > 1.0f / 255;
  }
  for (size_t c = 0; c < 3; ++c) {
    s.rmseRgb[c] = std::sqrt(squares[c] / double(pixels));
    s.biasRgb[c] = sums[c] / double(pixels);
  }
  s.rmse = std::sqrt((squares[0] + squares[1] + squares[2]) / (3 * double(pixels)));
  s.bias = (sums[0] + sums[1] + sums[2]) / (3 * double(pixels));
  s.max = *std::ranges::max_element(largest);
  // Nearest rank: the least value that 99.9 % of the pixels do not exceed.
  const size_t rank = size_t(std::ceil(0.999 * double(pixels))) - 1;
  std::ranges::nth_element(largest, largest.begin() + std::ptrdiff_t(rank));
  s.p999 = largest[rank];
  s.over1 = double(over) / double(pixels);
  s.pixels = pixels;
  return s;
}

report::ErrorStats errorOf(Values measured, Values truth, std::span<const uint8_t> mask) {
  ErrorSum sum;
  sum.add(measured, truth, mask);
  return sum.stats();
}

uint64_t oneSided(Values measured, std::span<const uint8_t> surfaces,
                  std::span<const uint8_t> mask) {
  if (measured.size() != 4 * surfaces.size() || (!mask.empty() && mask.size() != surfaces.size()))
    throw std::invalid_argument("pictures to compare differ in size");
  uint64_t count = 0;
  for (size_t p = 0; p < surfaces.size(); ++p)
    count += (measured[4 * p + 3] != 0) != (surfaces[p] != 0) && (mask.empty() || mask[p] == 0);
  return count;
}

report::ImageError imageError(const report::Picture& measured, const report::Picture& truth,
                              std::span<const uint8_t> edges) {
  // A picture has a value everywhere, whatever its alpha says.
  std::vector<float> a = measured.rgba, b = truth.rgba;
  for (auto* values : {&a, &b})
    for (size_t i = 3; i < values->size(); i += 4) (*values)[i] = 1;
  report::ImageError e{.all = errorOf(a, b),
                       .interior = errorOf(a, b, edges),
                       .relmse = relativeError(a, b, {}),
                       .relmseInterior = relativeError(a, b, edges)};
  const std::vector<float> perceived = flip(measured, truth);
  e.flip = meanOf(perceived, {});
  e.flipInterior = meanOf(perceived, edges);
  return e;
}

}  // namespace sb
