#include "reports/atomic_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace report {
namespace {

namespace fs = std::filesystem;

/// The file that a link leads to.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);
  return error ? path : target;
}

fs::path temporaryOf(fs::path path) {
  path += ".tmp" + std::to_string(getpid());
  return path;
}

/// Writes without protection; gives the reason of a failure or "".
std::string writeDirectly(const fs::path& path, std::string_view content) {
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  out.write(content.data(), std::streamsize(content.size()));
  out.close();
  if (out) return "";
  return errno ? std::strerror(errno) : "writing failed";
}

std::string write(const fs::path& path, std::string_view content) {
  if (path.empty()) return "the path is empty";
  if (fs::is_directory(path)) return "it is a folder";
  if (isSpecialFile(path)) return writeDirectly(path, content);
  const fs::path target = resolved(path), temporary = temporaryOf(target);
  std::string why = writeDirectly(temporary, content);
  std::error_code error;
  if (why.empty()) {
    fs::rename(temporary, target, error);
    if (!error) return "";
    why = error.message();
  }
  fs::remove(temporary, error);
  return why;
}

}  // namespace

// Renaming over a device or a pipe would replace it by a file.
bool isSpecialFile(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void writeAtomically(const fs::path& path, std::string_view content) {
  if (const std::string why = write(path, content); !why.empty())
    throw std::runtime_error("cannot write " + path.string() + ": " + why);
}

std::string whyNotWritable(const fs::path& path) {
  if (path.empty()) return "the path is empty";
  if (fs::is_directory(path)) return "it is a folder";
  if (isSpecialFile(path)) return access(path.c_str(), W_OK) == 0 ? "" : std::strerror(errno);
  const fs::path temporary = temporaryOf(resolved(path));
  const std::string why = writeDirectly(temporary, "");
  std::error_code ignored;
  fs::remove(temporary, ignored);
  return why;
}

}  // namespace report
