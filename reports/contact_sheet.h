// Many pictures in one, for looking at.
#pragma once

#include <span>
#include <vector>

#include "reports/picture.h"

namespace report {

/// Cells of width x height in rows of `columns`, the first at the top left, an empty one where a
/// span is empty. What is seen of a cell ends at its alpha: there, and between cells, it is dark
/// grey, so that black is shadow. Cells shrink by a whole factor until neither side of the sheet
/// exceeds `side`.
Picture contactSheet(uint32_t width, uint32_t height, std::span<const std::span<const float>> cells,
                     uint32_t columns, uint32_t side = 4096);

}  // namespace report
