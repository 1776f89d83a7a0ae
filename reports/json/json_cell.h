// One cell in JSON: the entries of Google Benchmark's schema that toJson() writes for it.
#pragma once

#include "reports/json/json_error.h"
#include "reports/json/json_field.h"
#include "reports/record.h"

namespace report {

/// The keys that say which cell it is: `knobs` by name, and in `knobs_changed` the names of those
/// that are not at their defaults, in order.
void putId(Json& out, const CellId& id);
/// The inverse, whatever else is in the object. Throws ReadError.
CellId readId(const Field& object);
/// Of a text. Throws ReadError.
Role readRole(const Field& text);

/// A list: one entry a repetition, and the aggregate that holds the record.
Json cellToJson(const Record& record);
/// Those of many cells: one record for each aggregate entry; the repetitions of its name before it
/// are its blocks. Throws ReadError.
std::vector<Record> readRecords(const Field& entries);
/// The inverse of cellToJson. Throws ReadError.
Record readCell(const Field& entries);

}  // namespace report
