#include "reports/bounded_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace report {

namespace fs = std::filesystem;

std::string readBounded(const fs::path& path, uint64_t most) {
  const auto refuse = [&](const std::string& why) {
    throw std::runtime_error("cannot read " + path.string() + ": " + why);
  };
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) refuse("there is no such file");
  if (!fs::is_regular_file(status)) refuse("it is no regular file");
  const auto tooLarge = [&](uint64_t bytes) {
    refuse("it has " + std::to_string(bytes) + " bytes, expected at most " + std::to_string(most));
  };
  const uint64_t size = fs::file_size(path, error);
  if (!error && size > most) tooLarge(size);
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) refuse(errno ? std::strerror(errno) : "opening failed");
  // It may grow while it is read.
  std::string text;
  char part[1 << 16];
  while (in.read(part, sizeof part) || in.gcount() > 0) {
    text.append(part, size_t(in.gcount()));
    if (text.size() > most) tooLarge(text.size());
  }
  if (in.bad()) refuse("reading failed");
  return text;
}

}  // namespace report
