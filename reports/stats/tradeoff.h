// What accuracy costs: points of (time, error), their Pareto front, and the tables that answer
// "what do I get for this time" and "what do I pay for this error". Computed from records alone, so
// that a report of an old file shows the same.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/record.h"
#include "reports/stats/stats.h"

namespace report {

enum class ErrorKind : uint8_t { Visibility, Image };

/// A cell's time and error with 95 % intervals, which hold the point itself also where the median
/// that they are of lies beside it.
struct TradePoint {
  const Record* record = nullptr;
  std::string technique;   ///< one of TradeOff::techniques
  double time = 0;         ///< milliseconds of the compared time: CPU on software devices, else GPU
  Interval timeInterval;   ///< of the median of the means of blocks
  /// Time over that of the same cell without shadows, as the record's ratio to it says; over the
  /// group's baseline where the record has none. Absent: there is no baseline.
  std::optional<double> timesBaseline;
  double error = 0;        ///< RMSE
  double weighted = 0;     ///< of visibility, weighed by reflected light; `error` where there is none
  Interval errorInterval;  ///< over seeds; a point for what is not stochastic
  uint64_t bytes = 0;
  /// No other point is as fast and as exact by both errors, and better in one.
  bool front = false;
  /// On the front, but there are values within the intervals of this point and of one other at
  /// which that other is as fast and as exact at once, and better in one. So a neighbour that is
  /// certainly slower or certainly less exact leaves a point certain.
  bool uncertain = false;
};

/// Best error of a technique within a time, or least time within an error; null when none is.
struct TableCell {
  std::string technique;
  const TradePoint* point = nullptr;
};
struct TableRow {
  double limit = 0;              ///< a multiple of the baseline's time, or an RMSE
  std::vector<TableCell> cells;  ///< one a technique, in the order of TradeOff::techniques
};

/// error ~ knob^-order, fitted over cells that differ in this knob alone.
struct Convergence {
  std::string technique;
  std::string of = "RMSE";  ///< or "noise": the standard deviation over seeds, visibility
  std::string knob;
  /// What else varies among the technique's cells, as it is in this series: "kernel:9/seed:1", or "".
  std::string others;
  double order = 0;
  Interval interval;    ///< 95 %, of the slope's regression
  uint32_t points = 0;  ///< at least 3
};

/// "Halving the error costs x times the time", along a technique's own front.
struct Exchange {
  std::string technique;
  std::optional<double> factor;  ///< absent: fewer than 3 points, or error does not fall with time
  std::string text;              ///< one sentence for people
};

/// One scene at one size on one backend's device. Moved, never copied: the tables point to
/// `points`.
struct TradeOff {
  TradeOff() = default;
  TradeOff(TradeOff&&) = default;
  TradeOff& operator=(TradeOff&&) = default;

  std::string scene, backend, device;
  uint32_t width = 0, height = 0;
  ErrorKind kind = ErrorKind::Visibility;
  std::string timeKey;             ///< "cpu_ms" or "frame_ms"
  std::optional<double> baseline;  ///< least time of one, with or without error; milliseconds
  /// TECHNIQUE[+TRANSPARENCY][@LIGHTS], in order of appearance.
  std::vector<std::string> techniques;
  std::vector<TradePoint> points;    ///< cells that are ok, not contaminated, and have an error
  std::vector<TableRow> equalTime;   ///< timesBaseline at most 1, 2, 4, 8, 16; empty without one
  std::vector<TableRow> equalError;  ///< RMSE 1e-1, 3e-2, 1e-2, 3e-3
  std::vector<Convergence> orders;
  std::vector<Exchange> exchanges;
};

/// `run` must outlive the result. The tracer's row joins every backend's points
/// of its scene and size when the compared time is CPU time; where there are none it stands alone.
std::vector<TradeOff> tradeOffs(const Run& run, ErrorKind kind = ErrorKind::Visibility);
std::vector<TradeOff> tradeOffs(Run&& run, ErrorKind kind = ErrorKind::Visibility) = delete;

}  // namespace report
