// The squared visibility error of a cell split by cause. Each value (pixel, channel) gives its
// squared error to exactly one cause, except that the variance over seeds of a stochastic technique
// goes to noise first.
//   noise           what the mean over seeds does not have
//   resolution      the truth jumps within the lookup's reach or in the pixels beside, and the
//   value
//                   lies between what it is there: texels and filter cannot do better
//   inner-layer     elsewhere, on a translucent receiver that not all light reaches
//   penumbra        elsewhere, where a part of a light with an extent arrives
//   self-shadowing  elsewhere, darker than the truth
//   leaking         elsewhere, lighter than the truth
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "suites/metrics/error.h"

namespace sb {

enum class Cause : uint8_t { Noise, Resolution, InnerLayer, Penumbra, SelfShadowing, Leaking };
inline constexpr size_t kCauses = 6;
const char* causeName(Cause cause);

struct ValueRange {
  std::array<float, 3> low, high;
};

/// One light at one layer.
struct BlameInput {
  Values measured;              ///< of one seed; of the verified frame
  Values truth;
  Values mean;                  ///< over seeds; empty: not stochastic
  Values variance;              ///< over seeds, RGB; empty: not stochastic
  uint32_t seeds = 1;           ///< that mean and variance are over
  std::span<const uint8_t> surfaces;  ///< as Truth::surfaces of the layer
  bool areaLight = false;             ///< the light has an extent: its shadows have penumbrae
  /// Least and greatest truth around a pixel, as far as a lookup reaches. Asked only for pixels with
  /// an error above 1/255. Null: there are no lookups, and no resolution to blame.
  std::function<ValueRange(uint32_t x, uint32_t y)> truthAround;
};

class BlameSum {
 public:
  BlameSum(uint32_t width, uint32_t height);
  /// Stochastic: splits E[e^2] = variance + bias^2, where bias^2 is (mean - truth)^2 less what the
  /// mean over seeds still varies; else (measured - truth)^2.
  void add(const BlameInput& input);
  /// Shares sum to 1 within rounding. A cause whose bias is noise alone, and which that correction
  /// takes below 0, has none.
  report::Blame blame() const;
  /// Colour of each pixel: its largest cause, as bright as its error's root (sRGB bytes, RGB, row 0
  /// at the top). Colours in `causeColor`.
  std::vector<uint8_t> picture() const;

 private:
  uint32_t m_width, m_height;
  std::vector<std::array<float, kCauses>> m_squares;
  uint64_t m_values = 0;
};

/// sRGB bytes.
std::array<uint8_t, 3> causeColor(Cause cause);

}  // namespace sb
