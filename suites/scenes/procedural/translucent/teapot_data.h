// Control points of the Utah teapot: the table behind the procedural scene "teapot".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace sb {

constexpr size_t kTeapotPatches = 32;
constexpr size_t kTeapotPoints = 290;  ///< distinct ones of the original 306

/// Of each patch: 4 x 4 indices into kTeapotControlPoints.
extern const std::array<std::array<uint16_t, 16>, kTeapotPatches> kTeapotPatchPoints;
/// Positions, z up; the pot is about 6.4 long, 4 wide and 3.15 high.
extern const std::array<std::array<float, 3>, kTeapotPoints> kTeapotControlPoints;

}  // namespace sb
