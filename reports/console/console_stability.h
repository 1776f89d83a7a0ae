// Hard cases for the console: a table of verdicts, technique by case, and what exceeded what.
#pragma once

#include <string>

#include "reports/record.h"

namespace report {

/// "" without hard cases.
std::string toTable(const std::vector<StabilityRecord>& records);

}  // namespace report
