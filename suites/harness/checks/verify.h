// Checks of pictures within a run.
#pragma once

#include <cstdint>
#include <string>

#include "reports/picture.h"
#include "reports/record.h"

namespace sb {

/// Content hash of the exact floats.
std::string contentHashOf(const report::Picture& picture);

/// Values (of any channel) that are NaN or infinite.
uint64_t countNonFinite(const report::Picture& picture);

/// Largest difference of a colour channel in steps of the 8-bit sRGB pictures, times `exposure`; 255
/// for different sizes.
int maxDifference255(const report::Picture& a, const report::Picture& b, float exposure = 1);
/// Pixels that differ by more than one such step in any channel.
uint64_t pixelsBeyondOneStep(const report::Picture& a, const report::Picture& b,
                             float exposure = 1);

/// All pixels have one value, as when nothing of the scene was drawn.
bool isUniform(const report::Picture& picture);

/// Why a verified record cannot be believed, or "": pictures that are not finite or not those of
/// the untimed run, scenes of which nothing was drawn.
std::string whyRefused(const report::Record& record);

}  // namespace sb
