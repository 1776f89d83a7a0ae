// Tables of the console.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace report {

/// Characters that UTF-8 text shows, not its bytes.
size_t seenWidth(const std::string& text);

/// Lines of `rows` with their columns aligned; a row may end early. The first `left` columns start
/// together, the others end together.
std::string alignedTable(const std::vector<std::vector<std::string>>& rows, size_t left,
                         const std::string& indent);

}  // namespace report
