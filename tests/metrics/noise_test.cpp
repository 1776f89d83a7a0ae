// Moments over seeds, the exact binomial test (values by scipy.stats.binomtest), regions of equal
// truth.
#include "suites/metrics/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "suites/metrics/certificate.h"

namespace sb {
namespace {

TEST(SeedMoments, MeanAndVarianceOfEveryValue) {
  SeedMoments m;
  m.add(std::vector<float>{1, 0, 5, 1});
  EXPECT_EQ(m.variance(), std::vector<float>(4, 0.0f));
  m.add(std::vector<float>{2, 0, 5, 1});
  m.add(std::vector<float>{6, 0, 5, 1});
  EXPECT_EQ(m.seeds(), 3u);
  EXPECT_EQ(m.mean(), (std::vector<float>{3, 0, 5, 1}));
  EXPECT_EQ(m.variance(), (std::vector<float>{7, 0, 0, 0}));
  EXPECT_THROW(m.add(std::vector<float>(8)), std::invalid_argument);
}

TEST(Binomial, EqualsTheExactTest) {
  struct Case {
    uint64_t passes, trials;
    double q, p;
  };
  const Case cases[] = {{3, 10, 0.5, 0.34375},
                        {0, 20, 0.1, 0.25452997802490435},
                        {510, 1000, 0.5, 0.5479727459234766},
                        {400, 1000, 0.5, 2.728464156065976e-10},
                        {52, 1000000, 3e-5, 0.00023190873044680752},
                        {299000, 1000000, 0.3, 0.029096319030430917},
                        {7, 7, 0.2, 1.28e-5},
                        {999000, 1000000, 0.9992, 9.45039445109176e-12}};
  for (const Case& c : cases)
    EXPECT_NEAR(binomialPValue(c.passes, c.trials, c.q) / c.p, 1, 1e-5)
        << c.passes << " of " << c.trials;
}

TEST(Binomial, EveryOutcomeOfASmallCaseAgainstItsSum) {
  for (const double q : {0.05, 0.3, 0.5, 0.77}) {
    constexpr uint64_t n = 12;
    std::vector<double> pmf;
    for (uint64_t k = 0; k <= n; ++k) {
      double c = 1;
      for (uint64_t i = 0; i < k; ++i) c = c * double(n - i) / double(i + 1);
      pmf.push_back(c * std::pow(q, double(k)) * std::pow(1 - q, double(n - k)));
    }
    for (uint64_t k = 0; k <= n; ++k) {
      double expected = 0;
      for (const double p : pmf)
        if (p <= pmf[k] * (1 + 1e-7)) expected += p;
      EXPECT_NEAR(binomialPValue(k, n, q), expected, 1e-9) << q << " " << k;
    }
  }
}

TEST(Binomial, CertaintiesAndLargeCounts) {
  EXPECT_EQ(binomialPValue(0, 100, 0), 1);
  EXPECT_EQ(binomialPValue(1, 100, 0), 0);
  EXPECT_EQ(binomialPValue(100, 100, 1), 1);
  EXPECT_EQ(binomialPValue(99, 100, 1), 0);
  EXPECT_EQ(binomialPValue(0, 0, 0.5), 1);
  EXPECT_THROW(binomialPValue(2, 1, 0.5), std::invalid_argument);
  // Four standard deviations of a billion: nearly the normal distribution's.
  const double sigma = std::sqrt(1e9 * 0.25);
  EXPECT_NEAR(binomialPValue(uint64_t(5e8 + 4 * sigma), 1000000000, 0.5) / 6.334e-5, 1, 0.01);
}

report::RegionTest region(double q, double p, double error = 1e-4) {
  return {.q = q, .trials = 1000000, .mean = q, .error = error, .pValue = p};
}

TEST(Certificate, BonferroniOverAllRegions) {
  report::Certificate c;
  for (int i = 0; i < 10; ++i) c.regions.push_back(region(0.5, 0.5));
  judge(c);
  EXPECT_EQ(c.unbiased, true);
  EXPECT_EQ(c.informative, 10u);
  c.regions[3].pValue = 2e-7;
  judge(c);
  EXPECT_EQ(c.unbiased, true);
  c.regions[3].pValue = 0.9e-7;
  judge(c);
  EXPECT_EQ(c.unbiased, false);
}

TEST(Certificate, WhereNothingWasTestedNothingIsKnown) {
  report::Certificate c;
  judge(c);
  EXPECT_FALSE(c.unbiased);
  EXPECT_NE(c.why, "");
  // Lit and dark regions alone: a technique that never blocks passes them.
  c.regions = {region(1, 1), region(0, 1)};
  judge(c);
  EXPECT_FALSE(c.unbiased);
  EXPECT_NE(c.why.find("chance"), std::string::npos) << c.why;
  // They can still refute.
  c.regions[0].pValue = 0;
  judge(c);
  EXPECT_EQ(c.unbiased, false);
  // Draws enough to find 1 % with a probability of 0.99 at this level, and not quite enough: 5.45
  // and 2.33 standard errors.
  c.regions = {region(0.5, 0.5, 0.01 / 7.8)};
  judge(c);
  EXPECT_EQ(c.unbiased, true);
  c.regions = {region(0.5, 0.5, 0.01 / 7.0)};
  judge(c);
  EXPECT_FALSE(c.unbiased);
  EXPECT_NE(c.why.find("too few"), std::string::npos) << c.why;
}

TEST(Certificate, MeansAreTestedByHowSeedsScatter) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.01);
  const auto test = [&](double q, double bias, size_t seeds) {
    std::vector<double> means(seeds);
    for (double& m : means) m = q + bias + noise(random);
    report::RegionTest t{.q = q};
    testMeans(t, means);
    return t;
  };
  EXPECT_GT(test(0.5, 0, 64).pValue, 1e-4);
  EXPECT_LT(test(0.5, 0.02, 64).pValue, 1e-9);
  EXPECT_NEAR(test(0.5, 0, 64).error, 0.01 / 8, 4e-4);
  // The p-value of the t distribution: t = 2 with 3 degrees of freedom has 0.1393.
  report::RegionTest t{.q = 0};
  std::vector<double> five = {0.3, 0.1, 0.5, 0.2, 0.4};  // mean 0.3, error 0.0707
  testMeans(t, five);
  EXPECT_NEAR(t.mean, 0.3, 1e-12);
  EXPECT_NEAR(t.error, std::sqrt(0.1 / 20), 1e-12);
  EXPECT_NEAR(t.pValue, 0.01324, 2e-4);  // t = 4.243 with 4 degrees of freedom
}

TEST(Certificate, SeedsThatAgreeDecideCertaintiesAlone) {
  const std::vector<double> lit(8, 1.0), almost(8, 0.996);
  report::RegionTest t{.q = 1};
  testMeans(t, lit);
  EXPECT_EQ(t.pValue, 1);
  testMeans(t, almost);
  EXPECT_EQ(t.pValue, 0);
  t.q = 0.999;
  testMeans(t, lit);
  EXPECT_EQ(t.pValue, 1) << "no event in few draws refutes nothing";
  EXPECT_EQ(t.error, 0) << "and informs about nothing";
}

TEST(UniformRegions, AreConnectedEqualAndOpen) {
  //   a a b b
  //   a x b c      x: masked; c differs; the last pixel shows no surface
  //   a a b -
  const float rows[3][4] = {{1, 1, 2, 2}, {1, 1, 2, 3}, {1, 1, 2, 2}};
  std::vector<float> truth;
  for (const auto& row : rows)
    for (const float v : row) truth.insert(truth.end(), {v, v, v, 1});
  truth[4 * 11 + 3] = 0;
  std::vector<uint8_t> mask(12, 0);
  mask[5] = 1;
  const auto regions = uniformRegions(truth, mask, 4, 3, 2);
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0], (std::vector<uint32_t>{0, 1, 4, 8, 9}));
  EXPECT_EQ(regions[1], (std::vector<uint32_t>{2, 3, 6, 10}));
  EXPECT_EQ(uniformRegions(truth, mask, 4, 3, 5).size(), 1u);
}

TEST(UniformRegions, AGradientIsNone) {
  std::vector<float> truth;
  for (int i = 0; i < 100; ++i) truth.insert(truth.end(), {float(i) * 1e-6f, 0, 0, 1});
  for (const auto& region : uniformRegions(truth, {}, 100, 1, 1)) EXPECT_LE(region.size(), 2u);
}

}  // namespace
}  // namespace sb
