// The error of a cell beside its cost, as plain data (spec 16, Error metrics; decision D10). Every
// error is measured minus truth, in linear values: visibility in [0,1], or radiance before tone
// mapping. Angles of view: `all` counts every compared pixel, `interior` leaves out the pixels within
// 2 px of a discontinuity of the truth.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace report {

/// Error over a set of pixels with three channels each; all 0 without pixels.
struct ErrorStats {
  double rmse = 0;   ///< over pixels and channels
  double bias = 0;   ///< mean signed error over pixels and channels
  double max = 0;    ///< largest absolute error of a channel
  double p999 = 0;   ///< 99.9th percentile over pixels of a pixel's largest absolute error
  double over1 = 0;  ///< share of pixels with a channel off by more than 1/255, [0,1]
  std::array<double, 3> rmseRgb = {};
  std::array<double, 3> biasRgb = {};
  uint64_t pixels = 0;
};

struct VisibilityError {
  ErrorStats all, interior;
  /// Pixels that show a surface in one of the two pictures alone: they have no error, so they are
  /// counted. `interior`: away from the truth's discontinuities, where there should be none.
  uint64_t oneSided = 0, oneSidedInterior = 0;
  /// RMSE with each pixel weighed by its share of the radiance that the lights would send to the eye
  /// without shadows; absent where they send none.
  std::optional<double> weighted, weightedInterior;
};

/// Visibility error of one light at one layer of surfaces.
struct LayerError {
  uint32_t light = 0;  ///< index into the scene's lights
  std::string lightName;
  uint32_t layer = 0;  ///< 0: first opaque surface; 1..4: layers from the eye
  VisibilityError error;
};

/// Visibility error over the first opaque surfaces of one kind, by the truth's visibility there and
/// away from its edges.
struct RegionError {
  std::string region;  ///< "dark", "saturated", "pale" or "lit"
  double share = 0;    ///< of the pixels of all regions
  double rmse = 0;
  double bias = 0;
  std::optional<double> noise;  ///< as NoiseRecord::noise; stochastic techniques only
};

struct ImageError {
  ErrorStats all, interior;
  double relmse = 0;  ///< mean of squared error / (squared truth + 0.01)
  double relmseInterior = 0;
  double flip = 0;    ///< mean LDR-FLIP of the tone-mapped pictures, [0,1] (Andersson et al. 2020)
  double flipInterior = 0;
};

/// A stochastic technique over seeds: how wrong its mean is, and how far one seed strays from it.
struct NoiseRecord {
  uint32_t seeds = 0;
  double noise = 0;  ///< root mean over values of the variance over seeds
  /// RMSE of the expectation: of the mean over seeds, less the variance that this mean still has.
  double biasRmse = 0;
  double bias = 0;      ///< mean signed error of the mean over seeds
  double biasLow = 0;   ///< its 95 % interval, from how the seeds' mean errors scatter
  double biasHigh = 0;
  double rmseLow = 0;   ///< 95 % interval of the median RMSE of one seed
  double rmseHigh = 0;
};

/// A region of receivers with one known expectation, and the test on it.
struct RegionTest {
  uint32_t light = 0;
  uint32_t layer = 0;
  uint32_t channel = 0;   ///< 0 red, 1 green, 2 blue
  uint32_t x = 0, y = 0;  ///< a pixel of the region, row 0 at the bottom
  uint64_t pixels = 0;    ///< of the region
  double q = 0;           ///< expectation: the truth's visibility
  uint64_t trials = 0;    ///< yes-or-no draws, or seeds where means are tested
  uint64_t passes = 0;    ///< of the trials; 0 where means are tested
  double mean = 0;        ///< what was found: the share that passed, or the mean over seeds
  double error = 0;       ///< standard error of `mean`: of the expectation, or as seeds scatter
  double pValue = 1;      ///< two-sided
};

/// Is the technique unbiased? No, if a region's p-value is below familyWiseError / regions. Yes, if
/// none is and a region was informative: its expectation lies between 0 and 1, and a bias of
/// `detectable` would have been found with a probability of 0.99. Otherwise it is undecided.
struct Certificate {
  std::optional<bool> unbiased;  ///< absent: undecided
  std::string why;               ///< it is undecided, or ""
  /// "binomial": exact, of lookups that average equal trials; "mean": Student's t of the regions'
  /// means over seeds, of all others.
  std::string test = "binomial";
  double familyWiseError = 1e-6;
  double detectable = 0.01;
  uint32_t informative = 0;         ///< regions
  std::vector<RegionTest> regions;  ///< all that were tested, none excused
};
/// "unbiased", "biased" or "undecided".
std::string_view certificateVerdict(const Certificate& certificate);

/// The cell's total squared visibility error split by cause; shares sum to 1, or are empty when
/// there is no error. Causes in order: "noise", "resolution", "inner-layer", "penumbra",
/// "self-shadowing", "leaking".
struct Blame {
  double mse = 0;  ///< what is split: mean squared visibility error
  std::vector<std::pair<std::string, double>> shares;
};

}  // namespace report
