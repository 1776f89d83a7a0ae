// The table that a figure comes down to, for console and page alike.
#pragma once

#include "reports/figure.h"
#include "reports/record.h"

namespace report {

struct FigureColumn {
  std::string title;
  bool number = true;
};

struct FigureEntry {
  std::string text;             ///< "-" when absent
  std::optional<double> value;  ///< to sort by
};

struct FigureRow {
  const Record* record = nullptr;  ///< the row's, or the first of several
  std::string label;               ///< what sets the row apart from others of its technique
  std::vector<FigureEntry> entries;
};

struct FigureTable {
  std::string caption;
  std::vector<FigureColumn> columns;
  std::vector<FigureRow> rows;
};

FigureTable tableOf(const Figure& figure, const Run& run);

/// Cells of one technique on one backend that differ by the figure's x alone, by rising x.
struct FigureSeries {
  std::string label;
  std::vector<const Record*> records;
};
std::vector<FigureSeries> seriesOf(const Figure& figure, const Run& run);
/// The measures that scaling shows.
inline constexpr const char* kScalingMeasures[] = {"shadow_ms", "scene_ms", "combined_ms", "time"};

}  // namespace report
