// The files that a command is to write, checked before anything else is done.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "suites/cli/options/options.h"
#include "techniques/scene/scene.h"

namespace CLI {
class App;
}

namespace sb {

/// Option and path of each file that the command writes, pictures and journals not included.
std::vector<std::pair<std::string, std::string>> outputFiles(const Options& options);

/// Throws InputError when one of the files that `truth` or `render` will write of the scene cannot
/// be written: those of visibility belong to scenes with lights.
void requireOutputs(const Options& options, const Scene& scene);

/// Throws InputError, naming the option: an empty path, one file under two options, an output that
/// is an input.
void requireSaneFiles(const CLI::App& app, const Options& options);

/// The file that is meant, whatever links and dots lead to it.
std::filesystem::path realPath(const std::filesystem::path& path);

}  // namespace sb
