// Hard cases in JSON: key `stability` beside `benchmarks`, a list of objects
//   name, case, title, property, reason, technique, backend, parameter, logarithmic,
//   verdict, why, breaks_at, curve[{x, value, tolerance}]
// A value that is not a number is null.
#pragma once

#include "reports/json/json_error.h"
#include "reports/json/json_field.h"

namespace report {

Json stabilityToJson(const StabilityRecord& record);
StabilityRecord readStability(const Field& field);

}  // namespace report
