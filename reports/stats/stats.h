// Statistics of samples: quantiles, spread, intervals of medians, paired ratios.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "reports/record.h"

namespace report {

/// Linear-interpolated quantile of unsorted samples, q in [0,1]; 0 for no samples.
double quantile(std::vector<double> samples, double q);
double median(std::span<const double> samples);

/// Median, quartiles, percentiles, coefficient of variation; all 0 without samples.
Distribution distribution(std::span<const double> samples);

struct Interval {
  double low = 0;
  double high = 0;
};

/// 95 % interval of the median by order statistics (binomial, distribution-free). The whole range
/// for fewer than six samples. Any number of samples: sums of the binomial are taken in logarithms.
Interval medianInterval(std::span<const double> samples);

/// Median of `a` over median of `b`, so that it is the quotient of the medians that are shown, and
/// its 95 % percentile-bootstrap interval (Efron 1979; 2000 resamples, fixed seed). Pairs are
/// resampled together: what hits both of a pair, as a drift of the machine does, cancels. Sizes are
/// equal and b > 0.
Ratio pairedRatio(std::span<const double> a, std::span<const double> b);

}  // namespace report
