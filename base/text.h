// Text from files and arguments on its way to a terminal, a table or a shell.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace base {

bool isUtf8(std::string_view text);

/// Fit for one line of a terminal: control characters, marks that reorder text, and bytes that are
/// no UTF-8 stand as \xNN of their bytes.
std::string printable(std::string_view text);

/// The same for several lines: line feeds stay.
std::string printableLines(std::string_view text);

/// At most `most` bytes: the middle gives way to `gap`, for both ends of a message matter.
/// Characters stay whole.
std::string shortened(std::string_view text, size_t most, std::string_view gap = "...");

/// Longest line of an error, in bytes.
inline constexpr size_t kErrorLine = 300;
/// `printable`, and never longer than `kErrorLine`: the middle gives way, for the ends say where
/// and what was expected.
std::string errorLine(std::string_view text);

/// "1 cell", "2 cells"; `many` where it is not `one` and an s.
std::string counted(uint64_t n, const std::string& one, const std::string& many = "");

/// One word for a shell: as it is, or quoted; characters that a terminal acts upon as $'\xNN'.
std::string shellWord(std::string_view text);

}  // namespace base
