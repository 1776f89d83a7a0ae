#include "suites/scenes/gltf/source/file_io.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include "base/atomic_file.h"
#include "techniques/plan/error.h"

namespace sb {

std::vector<uint8_t> readWholeFile(const std::filesystem::path& path, size_t limit) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) throw InputError(path.string(), "file not found");
  if (!std::filesystem::is_regular_file(status))
    throw InputError(path.string(), "is not a regular file");
  const uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw InputError(path.string(), "cannot be read: " + error.message());
  if (size > limit)
    throw InputError(path.string(), "has " + std::to_string(size) + " bytes, at most " +
                                        std::to_string(limit) + " are read");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(path.string(), std::string("cannot be read: ") + std::strerror(errno));
  std::vector<uint8_t> bytes(size);
  in.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size));
  if (size_t(in.gcount()) != size) throw InputError(path.string(), "changed while it was read");
  return bytes;
}

void writeWholeFile(const std::filesystem::path& path, std::span<const uint8_t> bytes) {
  if (const std::string why = base::whyNotWritable(path); !why.empty())
    throw InputError(path.string(), why);
  base::writeAtomically(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace sb
