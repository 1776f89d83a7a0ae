// What must hold of any file at all.
#pragma once

#include <filesystem>
#include <string>

namespace sb::fuzz {

enum class Outcome { Loaded, Refused, Fault };

struct Verdict {
  Outcome outcome = Outcome::Refused;
  std::string why;  ///< of a fault
};

/// Loads `path`: either an error that is short, printable and names a field, or a scene that is
/// sound. With `exported`, the scene is also written to that path and must come back.
Verdict judge(const std::filesystem::path& path, const std::filesystem::path& exported);

}  // namespace sb::fuzz
