// The transfer function of sRGB (IEC 61966-2-1).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sb {

inline double decodeSrgb(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}
inline double encodeSrgb(double v) {
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}
inline uint8_t encodeSrgb8(double linear) {
  return uint8_t(std::lround(255 * encodeSrgb(std::clamp(linear, 0.0, 1.0))));
}

}  // namespace sb
