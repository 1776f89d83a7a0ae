// Texts of `bench --help` and `--version`.
#pragma once

#include <string>
#include <vector>

namespace sb {

/// Techniques, scenes, names of cells, exit codes.
std::string helpFooter();
/// "1, 2, 3".
std::string joinedNames(const std::vector<std::string>& names);
/// The words of a command line, for a shell.
std::string commandLine(const std::vector<std::string>& arguments);
/// Version, commit, build type, compiler, system and CPU.
std::string versionText();

}  // namespace sb
