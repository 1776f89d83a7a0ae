// Statements of a figure against what was measured, each backend for itself.
#pragma once

#include "reports/figure.h"
#include "reports/record.h"

namespace report {

enum class FigureVerdict : uint8_t {
  Reproduced,     ///< on every backend that was measured
  NotReproduced,  ///< on at least one
  Undecided,      ///< the intervals of both sides overlap
  NotMeasured,
};
std::string_view verdictName(FigureVerdict verdict);  ///< "reproduced", "NOT reproduced", ...

struct StatementResult {
  FigureVerdict verdict = FigureVerdict::NotMeasured;
  std::string found;  ///< "slope of time, ms, over quads: 0.01 < 0.02 (vulkan)"
  std::string why;    ///< of NotReproduced and NotMeasured
};

StatementResult evaluate(const Figure& figure, const FigureStatement& statement, const Run& run);

/// Value with an interval's half width of a line through points (x, y): at x = 0, and per x.
struct LineFit {
  double slope = 0, slopeHalf = 0;
  double intercept = 0;
};
/// Nothing with fewer than two different x.
std::optional<LineFit> fitLine(const std::vector<std::pair<double, double>>& points);

/// Three digits; as short as they allow.
std::string shortNumber(double value);

}  // namespace report
