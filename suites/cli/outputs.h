// The files of a run: JSON with its pictures beside it, CSV, and the report.
#pragma once

#include "suites/cli/options.h"
#include "suites/harness/judge.h"

namespace sb {

class Outputs {
 public:
  /// Throws InputError for what cannot be written.
  explicit Outputs(const Options& options);
  /// Pictures of cells that are finished: names are hashes of their bytes.
  void addPictures(PictureFiles files);
  /// After each group, so that a crash costs one group; pipes, reports and the like are written
  /// once, when all is finished.
  void write(const report::Run& run, bool finished);

 private:
  const Options& m_options;
  std::filesystem::path m_pictures;  ///< folder beside the JSON file; empty: none
  PictureFiles m_files;              ///< for the report
};

/// "results.json" -> "results.pictures".
std::filesystem::path picturesFolder(const std::filesystem::path& jsonFile);

}  // namespace sb
