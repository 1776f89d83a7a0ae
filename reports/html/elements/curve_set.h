// Plots of lines, drawn by the page's script: one colour a technique, one shape and dash a backend.
// Each stands beside a table that says the same in words.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reports/html/model.h"
#include "reports/json/json_error.h"

namespace report {

struct CurveLine {
  std::string technique, backend;
  std::string label = {};  ///< at its end, where lines of one technique and backend are several
  std::vector<std::array<double, 2>> points;      ///< x, y; what is no number is left out
  std::vector<std::array<double, 2>> limit = {};  ///< what is allowed, drawn broken
  std::optional<double> breaksAt = {};            ///< first x beyond the limit, marked
};

struct Curve {
  std::string xTitle, yTitle;
  bool logarithmicX = false;
  bool wideY = false;  ///< values span magnitudes, and may be 0
  std::vector<CurveLine> lines;
};

class CurveSet {
 public:
  /// The place that the script draws into; `caption` is HTML.
  std::string html(Curve curve, const std::string& caption);
  /// All curves, for the script.
  Json json(const PageModel& model) const;

 private:
  std::vector<Curve> m_curves;
};

}  // namespace report
