// The files of a run: JSON with its pictures beside it, CSV, and the report.
#pragma once

#include "suites/cli/options.h"
#include "suites/harness/judge.h"

namespace sb {

class Outputs {
 public:
  /// Throws InputError for what cannot be written.
  explicit Outputs(const Options& options);
  ~Outputs();
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  /// Pictures of cells that are finished: names are hashes of their bytes.
  void addPictures(const PictureFiles& files);
  /// After each group, so that a crash costs one group; pipes, reports and the like are written
  /// once, when all is finished.
  void write(const report::Run& run, bool finished);

 private:
  const Options& m_options;
  std::filesystem::path m_pictures;  ///< folder; empty: nobody wants pictures
  bool m_ownsFolder = false;         ///< for the report alone, removed in the end
};

}  // namespace sb
