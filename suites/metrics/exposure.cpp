#include "suites/metrics/exposure.h"

#include <cmath>

namespace sb {
namespace {

constexpr double kMiddleGrey = 0.18;
constexpr double kLitForDisplay = 3;  ///< stops

}  // namespace

float automaticExposure(const report::Picture& picture) {
  double logs = 0;
  uint64_t lit = 0;
  for (size_t i = 0; i + 3 < picture.rgba.size(); i += 4) {
    const float* v = picture.rgba.data() + i;
    const double luminance = 0.2126 * double(v[0]) + 0.7152 * double(v[1]) + 0.0722 * double(v[2]);
    if (!(luminance > 0) || !std::isfinite(luminance)) continue;
    logs += std::log2(luminance);
    ++lit;
  }
  if (lit == 0) return 1;
  const double stops = std::round(std::log2(kMiddleGrey) - logs / double(lit));
  return std::abs(stops) <= kLitForDisplay ? 1.0f : float(std::exp2(stops));
}

report::Picture exposed(const report::Picture& picture, float exposure) {
  if (exposure == 1) return picture;
  report::Picture out = picture;
  for (size_t i = 0; i < out.rgba.size(); ++i)
    if (i % 4 != 3) out.rgba[i] *= exposure;
  return out;
}

}  // namespace sb
