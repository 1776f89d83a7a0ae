// What the page is about, in its order: techniques and backends by first appearance, and one part a
// scene at a size with its records and trade-offs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/record_view.h"
#include "reports/stats/tradeoff.h"

namespace report {

/// One scene at one size, with one kind of compared time: GPU times and CPU times are not drawn
/// into one plot.
struct ScenePart {
  std::string id;  ///< of the element
  std::string scene;
  uint32_t width = 0, height = 0;
  std::string timeKey;        ///< "cpu_ms" or "frame_ms"; "" when no cell has a time
  std::vector<size_t> cells;  ///< indices into Run::records
  std::vector<const TradeOff*> visibility, image;
  std::string title() const;     ///< "window, 256x256"
  std::string timeName() const;  ///< "CPU time of all threads" or "frame time"
};

struct PageModel {
  explicit PageModel(const Run& run);
  PageModel(const PageModel&) = delete;  // parts point into the trade-offs

  const Run& run;
  std::vector<std::string> techniques, backends, scenes;
  std::string baseline;  ///< of the techniques the one without shadows; "": there is none
  std::vector<TradeOff> visibility, image;
  std::vector<ScenePart> parts;

  size_t indexOf(const Record& r) const { return size_t(&r - run.records.data()); }
  /// Class that gives the technique's colour: "t0", "t1", ... in order of appearance; "tn" for
  /// the baseline.
  std::string colorClass(const std::string& technique) const;
  /// Class that gives the backend's shape: "b0", "b1", ...
  std::string shapeClass(const std::string& backend) const;
  /// Name with its colour: what a technique looks like everywhere.
  std::string techniqueHtml(const std::string& technique) const;
  std::string backendHtml(const std::string& backend) const;
};

}  // namespace report
