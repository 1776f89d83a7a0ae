#include "suites/metrics/weighted.h"

#include <cmath>
#include <stdexcept>

namespace sb {

void WeightedSum::add(Values measured, Values truth, std::span<const float> weights,
                      std::span<const uint8_t> mask) {
  if (measured.size() != truth.size() || 4 * weights.size() != truth.size() ||
      (!mask.empty() && mask.size() != weights.size()))
    throw std::invalid_argument("pictures to compare differ in size");
  for (size_t p = 0; p < weights.size(); ++p) {
    if (measured[4 * p + 3] != 1 || truth[4 * p + 3] != 1 || (!mask.empty() && mask[p])) continue;
    double squares = 0;
    for (size_t c = 0; c < 3; ++c) {
      const double e = double(measured[4 * p + c]) - double(truth[4 * p + c]);
      squares += e * e / 3;
    }
    m_squares += double(weights[p]) * squares;
    m_weights += double(weights[p]);
  }
}

std::optional<double> WeightedSum::rmse() const {
  if (!(m_weights > 0)) return {};
  return std::sqrt(m_squares / m_weights);
}

}  // namespace sb
