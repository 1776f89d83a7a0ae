// Slopes and their intervals: Student's t against the printed table, a line without scatter, and
// the smallest regression that has an interval, worked out by hand. The last is also what the tests
// of orders and rates of exchange build on.
#include "reports/stats/regression.h"

#include <gtest/gtest.h>

#include <vector>

namespace report {
namespace {

TEST(Regression, StudentQuantilesAreThoseOfThePrintedTable) {
  const std::pair<uint32_t, double> kTable[] = {
      {1, 12.706}, {2, 4.303},  {3, 3.182},  {4, 2.776},  {5, 2.571},  {6, 2.447},
      {9, 2.262},  {10, 2.228}, {15, 2.131}, {30, 2.042}, {60, 2.000}, {120, 1.980}};
  for (const auto& [freedom, t] : kTable)
    EXPECT_NEAR(studentQuantile(freedom), t, 5e-4) << freedom << " degrees of freedom";
}

TEST(Regression, PointsOnALineHaveASlopeWithoutSpread) {
  const std::vector<std::pair<double, double>> points = {{0, 1}, {1, 3}, {2, 5}, {4, 9}};
  const Slope s = fitSlope(points);
  EXPECT_DOUBLE_EQ(s.value, 2);
  EXPECT_NEAR(s.interval.low, 2, 1e-12);
  EXPECT_NEAR(s.interval.high, 2, 1e-12);
}

// By hand: means 1 and 5/3, Sxx 2, Sxy 3, slope 3/2; residuals -1/6, 1/3, -1/6, sum of squares 1/6;
// standard error sqrt(1/6 / 1 / 2) = 0.288675; t(1) = 12.7062, half width 3.66797.
TEST(Regression, ThreePointsByHand) {
  const std::vector<std::pair<double, double>> points = {{0, 0}, {1, 2}, {2, 3}};
  const Slope s = fitSlope(points);
  EXPECT_DOUBLE_EQ(s.value, 1.5);
  EXPECT_NEAR(s.interval.low, 1.5 - 3.66797, 1e-4);
  EXPECT_NEAR(s.interval.high, 1.5 + 3.66797, 1e-4);
}

}  // namespace
}  // namespace report
