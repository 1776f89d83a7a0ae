// Text for a page: escaping, numbers as people read them, and bytes as data: URIs.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/text.h"
#include "reports/json/json_error.h"

namespace report {

using base::counted;

/// For HTML text and for attributes within either kind of quotes. What is not UTF-8, and control
/// characters, become U+FFFD.
std::string escaped(std::string_view text);

/// JSON that may stand within a script element: plain ASCII without <, > and &.
std::string scriptJson(const Json& json);

std::string base64(std::string_view bytes);
/// Hexadecimal digits, two a byte, as base64.
std::string base64OfHex(std::string_view hex);

/// Three significant digits; powers of ten only for what is very small.
std::string figure(double value);
std::string figure(const std::optional<double>& value);  ///< a dash when absent
std::string percent(double share);
std::string mebibytes(uint64_t bytes);
/// "1.25 [1.1, 1.4]"
std::string withInterval(double value, double low, double high);

}  // namespace report
