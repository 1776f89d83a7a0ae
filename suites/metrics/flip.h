// LDR-FLIP: how much a person would see flipping between two pictures (Andersson, Nilsson,
// Akenine-Moller, Oskarsson, Astrom, Fairchild 2020, "FLIP: A Difference Evaluator for Alternating
// Images").
#pragma once

#include "reports/picture.h"

namespace sb {

/// Pixels per degree of a 0.7 m wide 3840-pixel monitor seen from 0.7 m, as in the paper.
inline constexpr double kFlipPixelsPerDegree = 67.0206;

/// FLIP of every pixel, [0,1], row 0 at the bottom. Pictures are tone-mapped as their PNG is:
/// clamped to [0,1], linear RGB. Sizes are equal.
std::vector<float> flip(const report::Picture& measured, const report::Picture& truth,
                        double pixelsPerDegree = kFlipPixelsPerDegree);

}  // namespace sb
