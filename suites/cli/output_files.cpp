#include "suites/cli/output_files.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>

#include "base/atomic_file.h"
#include "reports/html/html.h"
#include "suites/cli/commands/commands.h"
#include "suites/cli/visibility_files.h"
#include "techniques/plan/error.h"

namespace sb {
namespace {

namespace fs = std::filesystem;
using Files = std::vector<std::pair<std::string, std::string>>;

/// Option and path of each file that the command reads.
Files inputFiles(const Options& o) {
  Files files;
  std::vector<std::string> scenes = o.selection.scenes;
  if (o.command == Command::Scene) scenes.push_back(o.scene.name);
  for (const std::string& scene : scenes) {
    files.emplace_back("the scene", scene);
    files.emplace_back("the scene", scene.substr(0, scene.rfind('?')));
  }
  if (o.measuring.suite.ends_with(".toml")) files.emplace_back("--suite", o.measuring.suite);
  if (o.command == Command::Report) files.emplace_back("the results", o.report.results);
  std::error_code ignored;
  std::erase_if(files, [&](const auto& f) { return !fs::is_regular_file(f.second, ignored); });
  return files;
}

/// Files that come beside those that are named.
Files companions(const Options& o) {
  if (o.command != Command::Measure || o.files.json.empty() || base::isSpecialFile(o.files.json))
    return {};
  return {{"the journal of --json", report::journalBeside(o.files.json).string()},
          {"the pictures of --json", report::picturesBeside(o.files.json).string()}};
}

}  // namespace

fs::path realPath(const fs::path& path) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(fs::absolute(base::linkTarget(path)), error);
  return error ? path : real;
}

Files outputFiles(const Options& o) {
  Files files;
  auto add = [&](const std::string& option, const std::string& path) {
    if (!path.empty()) files.emplace_back(option, path);
  };
  switch (o.command) {
    case Command::Measure:
      add("--json", o.files.json);
      add("--csv", o.files.csv);
      add("--html", o.files.html);
      add("--benchmark_out", o.benchmark.outFile);
      break;
    case Command::Render:
    case Command::Truth:
      add("--output", o.picture.prefix + ".png");
      add("--output", o.picture.prefix + ".exr");
      if (o.command == Command::Truth) add("--output", o.picture.prefix + ".edges.png");
      if (o.command == Command::Truth || o.picture.visibility)
        for (const std::string& path : visibilityFiles(o.picture.prefix)) add("--output", path);
      break;
    case Command::Scene:
      add("--export", o.scene.exportFile);
      break;
    case Command::Report:
      add("--output", o.files.html.empty()
                          ? fs::path(o.report.results).replace_extension(".html").string()
                          : o.files.html);
      break;
    case Command::Doctor:
    case Command::Cache:
      break;
  }
  return files;
}

void requireOutputs(const Options& options, const Scene& scene) {
  const auto ofLights = visibilityFiles(options.picture.prefix);
  for (const auto& [option, path] : outputFiles(options)) {
    const bool ofLight = std::ranges::find(ofLights, path) != ofLights.end();
    if (!ofLight || !scene.lights.empty()) requireWritable(option, path);
  }
}

void requireSaneFiles(const CLI::App& app, const Options& options) {
  std::vector<const CLI::App*> apps = {&app};
  for (const CLI::App* command : app.get_subcommands()) apps.push_back(command);
  for (const CLI::App* a : apps)
    for (const char* option : {"--json", "--csv", "--html", "--output", "--export", "--pictures",
                               "--shaders", "--suite", "--device"}) {
      const CLI::Option* found = a->get_option_no_throw(option);
      if (!found || found->count() == 0 || found->get_expected_max() == 0) continue;
      for (const std::string& value : found->results())
        if (value.empty()) throw InputError(option, "found an empty text, expected a value");
    }
  std::map<fs::path, std::string> taken;
  for (const auto& [option, path] : inputFiles(options)) taken[realPath(path)] = option;
  Files files = outputFiles(options);
  const Files more = companions(options);
  files.insert(files.end(), more.begin(), more.end());
  for (const auto& [option, path] : files) {
    // Devices and pipes keep nothing: several may go there.
    if (base::isSpecialFile(path)) continue;
    const auto [other, isNew] = taken.try_emplace(realPath(path), option);
    if (!isNew && other->second != option)
      throw InputError(option, "found " + path + ", which is also that of " + other->second +
                                   ", expected another file");
    if (!isNew) throw InputError(option, "found " + path + " twice, expected another file");
  }
}

}  // namespace sb
