// The error keys of a record, read: the inverse of putErrors.
#pragma once

#include "reports/json/json_field.h"

namespace report {

/// visibility, visibility_layers, visibility_regions, image, noise, certificate, blame,
/// truth_stderr; each may be missing.
void readErrors(const Field& entry, Record& record);

}  // namespace report
