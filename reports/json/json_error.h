// The error keys of a record in JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "reports/record.h"

namespace report {

using Json = nlohmann::ordered_json;

/// `<key>_why` for what is absent, when a reason is known.
void putWhy(Json& out, const Record& record, const std::string& key, bool absent);
/// visibility, visibility_layers, visibility_regions, image, noise, certificate, blame,
/// truth_stderr.
void putErrors(Json& out, const Record& record);

}  // namespace report
