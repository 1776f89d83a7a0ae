// The files of a run: JSON with its pictures beside it, CSV, and the report. They are written when
// the run has something to say, each by itself: one that fails costs none of the others.
#pragma once

#include "suites/cli/options/options.h"
#include "suites/harness/judge.h"

namespace sb {

class Outputs {
 public:
  /// Throws InputError for what cannot be written.
  explicit Outputs(const Options& options);

  /// Folder of pictures, where any are wanted; see picturesOf().
  void keepPictures(std::filesystem::path pictures) { m_pictures = std::move(pictures); }
  /// Pictures of cells that are finished: names are hashes of their bytes.
  void addPictures(const PictureFiles& files);
  /// Whether all of them could be written; what could not goes to a file in the folder for
  /// temporary ones, and both are said.
  bool write(const report::Run& run);
  /// The same for one file; without a path there is nothing to do.
  bool writeText(const std::string& option, const std::string& path, const std::string& content);

 private:

  const Options& m_options;
  std::filesystem::path m_pictures;
  std::string m_lostPictures;  ///< why some were not written
};

/// Folder of a run's pictures: beside --json, else beside the journal when a report needs them;
/// empty: nobody does.
std::filesystem::path picturesOf(const Options& options, const std::filesystem::path& journal);

}  // namespace sb
