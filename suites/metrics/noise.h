// Bias and noise of stochastic techniques apart, and regions of equal truth.
#pragma once

#include <cstdint>
#include <vector>

#include "suites/metrics/error.h"

namespace sb {

/// Mean and variance of every value over seeds (Welford 1962).
class SeedMoments {
 public:
  /// RGBA values of one seed, alpha 1 where there is a value; always of one size.
  void add(Values values);
  uint32_t seeds() const { return m_seeds; }
  const std::vector<float>& mean() const { return m_mean; }  ///< RGBA, alpha of the first seed
  /// Unbiased variance, RGB of each pixel in RGBA layout; 0 with one seed.
  std::vector<float> variance() const;

 private:
  uint32_t m_seeds = 0;
  std::vector<float> m_mean, m_squares;
};

/// Connected pixels (4-neighbours) of one layer with equal truth (to 1e-6 in each channel), whose
/// alpha is 1 and whose mask is 0, of at least `least` pixels. Each list is in row order.
std::vector<std::vector<uint32_t>> uniformRegions(Values truth, std::span<const uint8_t> mask,
                                                  uint32_t width, uint32_t height, uint32_t least);

}  // namespace sb
