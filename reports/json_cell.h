// One cell in JSON: the entries of Google Benchmark's schema that toJson() writes for it.
#pragma once

#include "reports/json_error.h"
#include "reports/json_field.h"
#include "reports/record.h"

namespace report {

/// A list: one entry a repetition, and the aggregate that holds the record.
Json cellToJson(const Record& record);
/// The inverse. Throws ReadError.
Record readCell(const Field& entries);

}  // namespace report
