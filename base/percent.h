// Percent-encoding: names in places whose own characters they may hold, and URIs.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace base {

/// "%41" as "A"; nothing when two hexadecimal digits do not follow every '%'.
std::optional<std::string> percentDecoded(std::string_view text);

/// Everything but letters, digits, '_', '-', '.' as %XX.
std::string percentEncoded(std::string_view text);

}  // namespace base
