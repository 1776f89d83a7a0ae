// Errors as pictures to look at.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reports/picture.h"

namespace sb {

/// Largest error of the scale; larger ones get its last colour. The scale is logarithmic from 1/1024.
inline constexpr float kErrorMapMost = 1.0f;
inline constexpr float kErrorMapLeast = 1.0f / 1024;

/// A perceptually uniform dark-to-bright scale (magma's kind, from its own construction), t in [0,1].
std::array<uint8_t, 3> scaleColor(float t);

/// Largest absolute difference of a pixel's channels on that scale; sRGB RGB, row 0 at the top.
std::vector<uint8_t> errorMap(const report::Picture& measured, const report::Picture& truth);

}  // namespace sb
