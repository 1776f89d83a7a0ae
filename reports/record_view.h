// What reports say about a cell: its technique and what sets it apart, and the time it is compared
// by.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/record.h"

namespace report {

/// "CSSM2", "CSSM2+DepthPeeling", "CSSM2@Clustered": as cells are named.
std::string techniqueOf(const Record& r);
/// "kernel:9 size:512 seed:7": what sets this cell apart from others of its technique; "" at its
/// defaults.
std::string variantOf(const CellId& id);
/// The time that cells are compared by: CPU time on software devices, else the frame's.
std::string timeKeyOf(const Record& r);
const std::optional<Distribution>& comparedTime(const Record& r);
/// Is the error of visibility less than three standard errors of the truth, which therefore cannot
/// tell it from 0? Never where the truth is exact.
bool belowTruth(const Record& r);
/// What scenes call for and techniques cannot show, in words, one line a scene and effect; of the
/// baseline only where nothing else shows it.
std::vector<std::string> unshownEffects(const Run& run);
/// The record's word on why a value is absent; "" when there is none.
std::string whyOf(const Record& r, const std::string& key);

}  // namespace report
