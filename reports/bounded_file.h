// Reading files that people name: regular ones, whole, and no larger than what is expected of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace report {

/// Throws std::runtime_error that names the path and says what is wrong: no such file, a folder, a
/// device or a pipe (which may never end), or more than `most` bytes.
std::string readBounded(const std::filesystem::path& path, uint64_t most);

}  // namespace report
