// JSON in Google Benchmark's schema with the keys of a record beside its own, so that its
// compare.py works on the file: one "iteration" entry per repetition, and one "aggregate" entry,
// the median, that carries the record. A cell that failed or was skipped is one aggregate
// "<cell>_failed" or
// "<cell>_skipped" with error_occurred and no time keys.
#pragma once

#include <string>

#include "reports/record.h"

namespace report {

std::string toJson(const Run& run);

}  // namespace report
