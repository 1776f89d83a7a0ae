// Files that are whole or not there: written beside their place and renamed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace report {

/// Writes `content` to `path` through a temporary file in the same folder. Throws std::runtime_error
/// that names the path; nothing is left behind then.
void writeAtomically(const std::filesystem::path& path, std::string_view content);

}  // namespace report
