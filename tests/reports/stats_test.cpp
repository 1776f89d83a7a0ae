// Statistics against values worked out by hand and against known ranks.
#include "reports/stats/stats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace report {
namespace {

std::vector<double> oneTo(int n) {
  std::vector<double> values(static_cast<size_t>(n));
  std::iota(values.begin(), values.end(), 1.0);
  std::shuffle(values.begin(), values.end(), std::mt19937(7));
  return values;
}

TEST(Stats, QuantilesInterpolateLinearly) {
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0.25), 1.75);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0), 1);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 1), 4);
  EXPECT_EQ(quantile({5}, 0.3), 5);
  EXPECT_EQ(quantile({}, 0.5), 0);
  EXPECT_EQ(median(std::vector<double>{3, 1, 2}), 2);
}

TEST(Stats, DistributionOfKnownSamples) {
  const Distribution d = distribution(std::vector<double>{2, 4, 4, 4, 5, 5, 7, 9});
  EXPECT_EQ(d.median, 4.5);
  EXPECT_EQ(d.q1, 4);
  EXPECT_EQ(d.q3, 5.5);
  EXPECT_NEAR(d.cv, std::sqrt(32.0 / 7.0) / 5.0, 1e-12);
  EXPECT_EQ(d.n, 8u);
  EXPECT_EQ(distribution({}).n, 0u);
  EXPECT_EQ(distribution(std::vector<double>{3}).cv, 0);
}

// Ranks of the distribution-free 95 % interval, as printed in tables of the sign test.
TEST(Stats, MedianIntervalHasTheBinomialRanks) {
  const std::pair<int, int> kLowRank[] = {{6, 1},  {8, 1},  {9, 2},   {10, 2},  {12, 3},  {15, 4},
                                          {20, 6}, {25, 8}, {30, 10}, {50, 18}, {100, 40}};
  for (const auto& [n, rank] : kLowRank) {
    const Interval i = medianInterval(oneTo(n));
    EXPECT_EQ(i.low, rank) << n << " samples";
    EXPECT_EQ(i.high, n + 1 - rank) << n << " samples";
  }
}

TEST(Stats, MedianIntervalHoldsForManySamples) {
  // Exact ranks by integer arithmetic (largest k with 40 sum_{i<k} C(n,i) <= 2^n).
  const std::pair<int, int> kLowRank[] = {{1000, 469},   {1074, 505},    {1075, 505},
                                          {1076, 506},   {2000, 956},    {10000, 4902},
                                          {100000, 49690}, {1000000, 499020}};
  for (const auto& [n, rank] : kLowRank) {
    std::vector<double> values(static_cast<size_t>(n));
    std::iota(values.begin(), values.end(), 1.0);
    const Interval i = medianInterval(values);
    EXPECT_EQ(i.low, rank) << n << " samples";
    EXPECT_EQ(i.high, n + 1 - rank) << n << " samples";
  }
}

TEST(Stats, FewSamplesGiveTheWholeRange) {
  for (int n = 1; n < 6; ++n) {
    EXPECT_EQ(medianInterval(oneTo(n)).low, 1);
    EXPECT_EQ(medianInterval(oneTo(n)).high, n);
  }
  EXPECT_EQ(medianInterval({}).high, 0);
}

TEST(Stats, PairedRatioOfProportionalSamplesIsExact) {
  const std::vector<double> b = {1, 2, 3, 4, 5, 6}, a = {2, 4, 6, 8, 10, 12};
  const Ratio r = pairedRatio(a, b);
  EXPECT_EQ(r.value, 2);
  EXPECT_EQ(r.low, 2);
  EXPECT_EQ(r.high, 2);
  EXPECT_EQ(r.n, 6u);
  EXPECT_EQ(pairedRatio({}, {}).n, 0u);
}

// Drift that hits both halves of a pair alike leaves the ratio alone.
TEST(Stats, PairedRatioIgnoresDrift) {
  std::vector<double> a, b;
  for (int i = 0; i < 20; ++i) {
    const double speed = 1 + 0.2 * i;
    a.push_back(3 * speed);
    b.push_back(2 * speed);
  }
  const Ratio r = pairedRatio(a, b);
  EXPECT_NEAR(r.low, 1.5, 1e-12);
  EXPECT_NEAR(r.high, 1.5, 1e-12);
}

std::vector<double> noisy(std::mt19937& random, size_t n, double centre) {
  std::vector<double> values(n);
  std::lognormal_distribution<double> noise(0, 0.15);
  for (double& v : values) v = centre * noise(random);
  return values;
}

TEST(Stats, TheRatioIsTheQuotientOfTheMediansThatAreShown) {
  // Pair by pair the middle is 3; the medians are 2 and 3.
  const std::vector<double> a = {1, 2, 9}, b = {4, 0.5, 3};
  EXPECT_EQ(pairedRatio(a, b).value, median(a) / median(b));
}

TEST(Stats, PairedRatioIsTheSameOnEveryCall) {
  std::mt19937 random(3);
  const auto a = noisy(random, 15, 2), b = noisy(random, 15, 1);
  const Ratio first = pairedRatio(a, b), second = pairedRatio(a, b);
  EXPECT_EQ(first.low, second.low);
  EXPECT_EQ(first.high, second.high);
  EXPECT_LT(first.low, first.value);
  EXPECT_GT(first.high, first.value);
}

TEST(Stats, BootstrapIntervalCoversTheTruthAboutAsOftenAsItSays) {
  std::mt19937 random(11);
  int covered = 0;
  constexpr int kTrials = 200;
  for (int i = 0; i < kTrials; ++i) {
    const Ratio r = pairedRatio(noisy(random, 20, 2), noisy(random, 20, 1));
    covered += r.low <= 2 && 2 <= r.high;
  }
  // 95 % asked for; the percentile bootstrap of a median of 20 gives a little less or more.
  EXPECT_GT(covered, int(0.88 * kTrials));
}

}  // namespace
}  // namespace report
