// Whole files in and out: regular files only (a pipe or a device would hang), and written through a
// temporary file that is renamed, so that no half of a file is ever seen.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace sb {

/// Bytes of a regular file. Throws InputError naming the path: not found, not a file, not readable,
/// larger than `limit`.
std::vector<uint8_t> readWholeFile(const std::filesystem::path& path, size_t limit);
/// base::writeAtomically; InputError naming the path where nothing can be written there.
void writeWholeFile(const std::filesystem::path& path, std::span<const uint8_t> bytes);

}  // namespace sb
