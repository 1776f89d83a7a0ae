// The run as one HTML file that needs nothing beside it: plots of error over time with their Pareto
// fronts, tables, pictures and the command that reproduces each point. Opens from disk; asks no
// network for anything, and its policy forbids it. Without scripts the tables and pictures stay.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "reports/record.h"

namespace report {

using Rgb8 = std::array<uint8_t, 3>;

struct HtmlSettings {
  /// Where <hash>.png lie; empty: no pictures are looked for.
  std::filesystem::path pictures;
  /// Colours of the error maps' scale, from the least error to the most, evenly spaced on the
  /// logarithm; empty: the legend has words alone.
  std::vector<Rgb8> errorScale;
  double errorLeast = 1.0 / 1024;
  double errorMost = 1;
  /// Colours of the blame maps' causes, by name.
  std::vector<std::pair<std::string, Rgb8>> causeColors;
};

/// Where a run that was written to `json` has its pictures: "a/results.json" has
/// "a/results.pictures".
std::filesystem::path picturesBeside(const std::filesystem::path& json);
/// Where a run that writes results `json` keeps what it has found so far.
std::filesystem::path journalBeside(const std::filesystem::path& json);

/// A picture that is missing, or whose name in the run is no hash, is a note in the page.
std::string toHtml(const Run& run, const HtmlSettings& settings);

}  // namespace report
