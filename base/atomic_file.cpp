#include "base/atomic_file.h"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace base {
namespace {

namespace fs = std::filesystem;

/// The file that a link leads to, there or not.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  const fs::path link = linkTarget(path);
  const fs::path target = fs::weakly_canonical(fs::absolute(link), error);
  return error ? link : target;
}

/// Signals wait while this lives, so that no temporary file outlives the program.
class SignalsWait {
 public:
  SignalsWait() {
    sigset_t set;
    sigemptyset(&set);
    for (const int s : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&set, s);
    pthread_sigmask(SIG_BLOCK, &set, &m_before);
  }
  ~SignalsWait() { pthread_sigmask(SIG_SETMASK, &m_before, nullptr); }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;

 private:
  sigset_t m_before = {};
};

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
  std::error_code error;
  if (path.empty()) return "the path is empty";
  if (fs::is_directory(path, error)) return "it is a folder";
  if (isSpecialFile(path)) return writeDirectly(path, content);
  const fs::path target = resolved(path), temporary = temporaryOf(target);
  const SignalsWait wait;
  std::string why = writeDirectly(temporary, content);
  if (why.empty()) {
    fs::rename(temporary, target, error);
    if (!error) return "";
    why = error.message();
  }
  fs::remove(temporary, error);
  return why;
}

}  // namespace

fs::path linkTarget(const fs::path& path) {
  fs::path at = path;
  std::error_code error;
  for (int i = 0; i < 40 && fs::is_symlink(fs::symlink_status(at, error)); ++i) {
    const fs::path next = fs::read_symlink(at, error);
    if (error) break;
    at = next.is_absolute() ? next : at.parent_path() / next;
  }
  return at;
}

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
  std::error_code error;
  if (path.empty()) return "the path is empty";
  if (fs::is_directory(path, error)) return "it is a folder";
  if (isSpecialFile(path)) return access(path.c_str(), W_OK) == 0 ? "" : std::strerror(errno);
  const fs::path target = resolved(path);
  if (fs::is_symlink(fs::symlink_status(target, error))) return "its links lead nowhere";
  if (!fs::is_directory(target.parent_path(), error))
    return "there is no folder " + target.parent_path().string();
  if (fs::exists(target, error) && access(target.c_str(), W_OK) != 0) return std::strerror(errno);
  const fs::path temporary = temporaryOf(target);
  const SignalsWait wait;
  const std::string why = writeDirectly(temporary, "");
  std::error_code ignored;
  fs::remove(temporary, ignored);
  return why;
}

}  // namespace base
