// The command line, parsed: what `./bench --help` describes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "suites/harness/gbench.h"
#include "suites/harness/selection.h"

namespace sb {

enum class Command : uint8_t { Measure, Render, Scene, Doctor, Truth, Cache, Report };

struct Options {
  std::vector<std::string> arguments;  ///< as given
  Command command = Command::Measure;
  Selection selection;
  BenchmarkFlags benchmark;
  std::string gl = "egl";  ///< which context "opengl" stands for when no backend is named
  std::string device;
  std::string shaderFolder;
  std::optional<double> budgetSeconds;
  std::optional<double> precisionPercent;
  std::string jsonFile, csvFile;
  std::string htmlFile;  ///< of `report`, empty: beside the JSON
  std::string suite;  ///< name or file; "": cells come from the selection
  std::optional<uint32_t> seeds;
  bool truth = true;
  bool cache = true;
  bool resume = false;
  std::string resumeFile;  ///< a journal or results; "": beside `jsonFile`
  bool allowSkips = false;
  std::optional<uint64_t> maxMemory;  ///< bytes
  bool list = false;
  bool validate = false;
  bool quiet = false;
  // render
  std::string outputPrefix = "render";
  bool visibility = false;
  std::optional<float> exposure;  ///< absent: automatic (suites/metrics/exposure.h)
  // cache
  bool clearCache = false;
  // scene
  std::string sceneName;
  bool sceneJson = false;
  std::string exportFile;
  // report
  std::string reportFile;  ///< JSON to read
  std::string pictureFolder;
};

/// Throws InputError for wrong arguments. When help or the version was asked for, prints it and
/// gives nothing.
std::optional<Options> parseOptions(std::vector<std::string> arguments);

}  // namespace sb
