// The error of visibility, weighed by the light that it concerns: a face that a light grazes reflects
// next to nothing of it, and nobody sees an error there.
#pragma once

#include "suites/metrics/error.h"

namespace sb {

/// Root of the mean squared error over pixels and channels, each pixel weighed by its share of all
/// radiance that the lights would send to the eye without shadows (Truth::reflected). Adds up lights
/// and layers.
class WeightedSum {
 public:
  /// Pixels count whose alpha is 1 in both and, if given, whose mask is 0. `weights`: one a pixel.
  void add(Values measured, Values truth, std::span<const float> weights,
           std::span<const uint8_t> mask = {});
  /// Absent where no light is reflected.
  std::optional<double> rmse() const;

 private:
  double m_squares = 0, m_weights = 0;
};

}  // namespace sb
