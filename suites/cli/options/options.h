// The command line, parsed: what `./bench --help` describes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "suites/harness/measuring/gbench.h"
#include "suites/harness/suite/selection.h"

namespace sb {

enum class Command : uint8_t { Measure, Render, Scene, Doctor, Truth, Cache, Report };

/// On what is drawn, and how.
struct DeviceOptions {
  std::string gl = "egl";  ///< which context "opengl" stands for when no backend is named
  std::string selector;    ///< number or part of the name
  std::string shaderFolder;
  bool validate = false;
  std::optional<uint64_t> maxMemory;  ///< bytes
};

/// How long and against what is measured.
struct MeasuringOptions {
  std::string suite;  ///< name or file; "": cells come from the selection
  std::optional<double> budgetSeconds;
  std::optional<double> precisionPercent;
  std::optional<uint32_t> seeds;
  bool truth = true;
  bool allowSkips = false;
};

/// Where results go; of `report`, where the page goes (empty: beside the JSON).
struct ResultFiles {
  std::string json, csv, html;
};

/// Whether and where a run goes on.
struct ResumeOptions {
  bool wanted = false;
  std::string file;  ///< a journal or results; "": beside ResultFiles::json
};

/// What is done with truths on disk.
struct CacheOptions {
  bool used = true;
  bool clear = false;  ///< the command `cache`
};

/// What `render` and `truth` write.
struct PictureOptions {
  std::string prefix = "render";
  bool visibility = false;
};

/// Of the command `scene`.
struct SceneOptions {
  std::string name;
  bool json = false;
  std::string exportFile;
};

/// What the command `report` reads.
struct ReportOptions {
  std::string results;   ///< JSON
  std::string pictures;  ///< folder; "": beside it
};

struct Options {
  std::vector<std::string> arguments;  ///< as given
  Command command = Command::Measure;
  Selection selection;
  BenchmarkFlags benchmark;
  DeviceOptions device;
  MeasuringOptions measuring;
  ResultFiles files;
  ResumeOptions resume;
  CacheOptions cache;
  PictureOptions picture;
  SceneOptions scene;
  ReportOptions report;
  std::optional<float> exposure;  ///< absent: automatic (suites/metrics/exposure.h)
  bool list = false;              ///< names alone
  bool quiet = false;
};

/// Throws InputError for wrong arguments. When help or the version was asked for, prints it and
/// gives nothing.
std::optional<Options> parseOptions(std::vector<std::string> arguments);

}  // namespace sb
