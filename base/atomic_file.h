// Files that are whole or not there: written beside their place and renamed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace base {

/// Writes `content` to `path` through a temporary file in the same folder. Throws
/// std::runtime_error that names the path; nothing is left behind then. What is no regular file
/// (/dev/stdout, a pipe) is written to directly; a symbolic link stays one, and what it
/// leads to is written, there or not yet.
void writeAtomically(const std::filesystem::path& path, std::string_view content);

/// Where a chain of symbolic links ends, whether or not something is there.
std::filesystem::path linkTarget(const std::filesystem::path& path);

/// The path names a device, a pipe or the like: every write there adds to those before.
bool isSpecialFile(const std::filesystem::path& path);

/// Why `path` cannot be written, or "": to be asked before minutes are spent on its content. Leaves
/// nothing behind.
std::string whyNotWritable(const std::filesystem::path& path);

}  // namespace base
