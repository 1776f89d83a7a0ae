// Error and noise apart by what the truth shows on opaque surfaces: shadows of lead lines, of
// saturated and of pale glass, and full light. Noise of stochastic techniques depends on the
// truth's value (p (1 - p)), so one figure for a picture hides where it lies.
#pragma once

#include <array>
#include <string_view>

#include "suites/metrics/error.h"

namespace sb {

enum class Region : uint8_t {
  Dark,       ///< no channel above 0.05
  Saturated,  ///< channels differ by more than half of the largest
  Pale,       ///< the rest below full light
  Lit,        ///< all channels within 1/255 of 1
};
inline constexpr size_t kRegions = 4;
std::string_view regionName(Region region);

/// `rgb`: the truth's visibility.
Region regionOf(const float* rgb);

class RegionSum {
 public:
  /// One light's first opaque surfaces. Pixels count whose alpha is 1 in both and whose mask is 0.
  /// `variance` over seeds as SeedMoments gives it; empty: nothing is random.
  void add(Values measured, Values truth, std::span<const uint8_t> mask, Values variance);
  /// Regions with pixels, in order.
  std::vector<report::RegionError> regions() const;

 private:
  struct Sum {
    uint64_t pixels = 0;
    double squares = 0, errors = 0, variance = 0;
  };
  std::array<Sum, kRegions> m_sums;
  bool m_noise = false;
};

}  // namespace sb
