// The files of the page as they are embedded in the program (reports/html/CMakeLists.txt).
#pragma once

#include <string_view>

namespace report {

/// "page.html", "page.css", "page.js", "library.js", and "page.js.sha256", "library.js.sha256":
/// hexadecimal digits. Empty for any other name.
std::string_view asset(std::string_view name);

}  // namespace report
