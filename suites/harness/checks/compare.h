// What cells of a group say about each other: ratios of time, and whether backends agree on the
// picture.
#pragma once

#include <span>

#include "suites/harness/group.h"

namespace sb {

/// A cell that has been measured.
struct Measured {
  CellResult* result = nullptr;
  const Samples* samples = nullptr;
  bool software = true;
};

/// Fills ratios and cross-backend differences of the records that are ok: time over the cell's
/// baseline, time over the same cell on other backends. Contaminated cells are in no ratio.
void compareCells(std::span<const Measured> cells);

}  // namespace sb
