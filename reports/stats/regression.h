// Straight lines through points, for orders of convergence and rates of exchange: ordinary least
// squares with the 95 % interval of the slope. The interval assumes scatter of one size around the
// line; deviations from a line that are no scatter (a curve) widen it all the same.
#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "reports/stats/stats.h"

namespace report {

/// 97.5 % quantile of Student's t distribution, which bounds a two-sided 95 % interval.
/// `freedom` is at least 1.
double studentQuantile(uint32_t freedom);

/// 95 % interval of the mean of independent samples, by Student's t; the sample itself, or 0, for
/// fewer than two.
Interval meanInterval(std::span<const double> samples);

struct Slope {
  double value = 0;
  Interval interval;  ///< 95 %
};

/// Slope of y over x for at least 3 points (x, y), not all at one x.
Slope fitSlope(std::span<const std::pair<double, double>> points);

}  // namespace report
