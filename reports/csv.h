// CSV of a run: one row a cell, nested keys flattened with `_`, RFC 4180 quoting.
#pragma once

#include <string>

#include "reports/record.h"

namespace report {

std::string toCsv(const Run& run);

}  // namespace report
