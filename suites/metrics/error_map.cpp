#include "suites/metrics/error_map.h"

#include <algorithm>
#include <cmath>

#include "suites/metrics/srgb.h"

namespace sb {
namespace {

struct Lab {
  double l, a, b;  ///< Oklab (Ottosson 2020)
};

std::array<uint8_t, 3> toSrgb(const Lab& c) {
  const double l = std::pow(c.l + 0.3963377774 * c.a + 0.2158037573 * c.b, 3);
  const double m = std::pow(c.l - 0.1055613458 * c.a - 0.0638541728 * c.b, 3);
  const double s = std::pow(c.l - 0.0894841775 * c.a - 1.2914855480 * c.b, 3);
  return {encodeSrgb8(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          encodeSrgb8(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          encodeSrgb8(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace

std::array<uint8_t, 3> scaleColor(float t) {
  // Lightness rises evenly; hue turns from blue over red to yellow, most colourful in the middle.
  const double x = std::clamp(double(t), 0.0, 1.0);
  const double hue = (-90 + 190 * x) * 3.14159265358979 / 180;
  const double chroma = 0.02 + 0.145 * std::sin(3.14159265358979 * std::pow(x, 0.9));
  return toSrgb({0.08 + 0.88 * x, chroma * std::cos(hue), chroma * std::sin(hue)});
}

std::vector<uint8_t> errorMap(const report::Picture& measured, const report::Picture& truth) {
  const float range = std::log(kErrorMapMost / kErrorMapLeast);
  std::vector<uint8_t> rgb(size_t(truth.width) * truth.height * 3);
  for (uint32_t y = 0; y < truth.height; ++y)
    for (uint32_t x = 0; x < truth.width; ++x) {
      const size_t p = 4 * (size_t(y) * truth.width + x);
      float e = 0;
      for (size_t c = 0; c < 3; ++c)
        e = std::max(e, std::abs(measured.rgba[p + c] - truth.rgba[p + c]));
      const float t = e > kErrorMapLeast ? std::log(e / kErrorMapLeast) / range : 0;
      const auto color = scaleColor(t);
      std::ranges::copy(color, rgb.begin() + std::ptrdiff_t(3 * (size_t(truth.height - 1 - y) *
                                                                 truth.width + x)));
    }
  return rgb;
}

}  // namespace sb
