// The table that a run prints.
#pragma once

#include <string>

#include "reports/record.h"

namespace report {

/// Plain text, one line a cell, with what to read it by. Never says "GPU" of a software device.
std::string toTable(const Run& run);

}  // namespace report
