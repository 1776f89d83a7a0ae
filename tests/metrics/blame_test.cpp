// Which cause takes which error, one pixel at a time.
#include "suites/metrics/blame.h"

#include <gtest/gtest.h>

#include <map>

namespace sb {
namespace {

struct One {
  float measured = 1, truth = 1;
  uint8_t surface = 1;
  bool edge = false;   ///< the truth around is 0..1
  float variance = -1; ///< below 0: not stochastic
  uint32_t seeds = 1u << 30;
  bool areaLight = false;
};

std::map<std::string, double> blameOf(const One& one) {
  const std::vector<float> measured = {one.measured, one.measured, one.measured, 1};
  const std::vector<float> truth = {one.truth, one.truth, one.truth, 1};
  const std::vector<float> variance = {one.variance, one.variance, one.variance, 0};
  const std::vector<uint8_t> surfaces = {one.surface};
  BlameInput input{.measured = measured, .truth = truth, .surfaces = surfaces};
  if (one.variance >= 0) input.mean = measured, input.variance = variance;
  input.seeds = one.seeds;
  input.areaLight = one.areaLight;
  input.truthAround = [&](uint32_t, uint32_t) {
    return one.edge ? ValueRange{{0, 0, 0}, {1, 1, 1}}
                    : ValueRange{{one.truth, one.truth, one.truth}, {one.truth, one.truth, one.truth}};
  };
  BlameSum sum(1, 1);
  sum.add(input);
  std::map<std::string, double> shares;
  for (const auto& [cause, share] : sum.blame().shares) shares[cause] = share;
  return shares;
}

TEST(Blame, EachErrorHasItsCause) {
  EXPECT_EQ(blameOf({.measured = 0.5f, .truth = 0, .edge = true})["resolution"], 1);
  EXPECT_EQ(blameOf({.measured = 0.5f, .truth = 0})["leaking"], 1);
  EXPECT_EQ(blameOf({.measured = 0.5f, .truth = 1})["self-shadowing"], 1);
  EXPECT_EQ(blameOf({.measured = 0.5f, .truth = 0.75f, .surface = 2})["inner-layer"], 1);
  // Before a pane in full light lies nothing: it shadows itself.
  EXPECT_EQ(blameOf({.measured = 0.5f, .truth = 1, .surface = 2})["self-shadowing"], 1);
  // Lighter than anything around: no filter makes that.
  EXPECT_EQ(blameOf({.measured = 1.5f, .truth = 0, .edge = true})["leaking"], 1);
  // A hard shadow has no penumbra: it is darker on one side, lighter on the other.
  for (const float hard : {0.0f, 1.0f})
    EXPECT_EQ(blameOf({.measured = hard, .truth = 0.5f, .areaLight = true})["penumbra"], 1);
  EXPECT_EQ(blameOf({.measured = 1, .truth = 0, .areaLight = true})["leaking"], 1);
  EXPECT_TRUE(blameOf({}).empty());
}

TEST(Blame, NoiseTakesTheVarianceAndTheMeanTheRest) {
  auto shares = blameOf({.measured = 0.5f, .truth = 0, .edge = true, .variance = 0.75f});
  EXPECT_NEAR(shares["noise"], 0.75, 1e-6);
  EXPECT_NEAR(shares["resolution"], 0.25, 1e-6);
  EXPECT_EQ(blameOf({.variance = 0.5f})["noise"], 1);
}

TEST(Blame, WhatTheMeanOfFewSeedsStillVariesIsNoBias) {
  // Errors of the mean that are those of chance: 4 seeds of variance 1 stray by 1/2.
  auto shares = blameOf({.measured = 0.5f, .truth = 0, .variance = 1, .seeds = 4});
  EXPECT_EQ(shares["noise"], 1);
  EXPECT_EQ(shares["leaking"], 0);
  // Over many pixels the excess of some and the lack of others cancel.
  BlameSum sum(4, 1);
  std::vector<float> mean, truth(16, 0.5f), variance(16, 0.04f);
  for (const float error : {0.1f, -0.02f, 0.14f, -0.1f}) mean.insert(mean.end(), {0.5f + error, 0.5f + error, 0.5f + error, 1});
  for (size_t p = 0; p < 4; ++p) truth[4 * p + 3] = 1;
  const std::vector<uint8_t> surfaces(4, 1);
  sum.add({.measured = mean,
           .truth = truth,
           .mean = mean,
           .variance = variance,
           .seeds = 4,
           .surfaces = surfaces});
  double noise = 0;
  for (const auto& [cause, share] : sum.blame().shares)
    if (cause == "noise") noise = share;
  EXPECT_NEAR(noise, 0.04 / (0.04 + (0.01 + 0.0196 - 0.02) / 4), 1e-3)
      << "leaking keeps what exceeds chance; the lack of self-shadowing does not count against it";
}

TEST(Blame, SharesOfSeveralLayersSumToOne) {
  BlameSum sum(2, 1);
  const std::vector<float> truth = {0, 0, 0, 1, 1, 1, 0.75f, 1};
  const std::vector<float> measured = {0.5f, 0.25f, 0, 1, 0.5f, 1, 0.75f, 1};
  const std::vector<uint8_t> surfaces = {1, 2};
  for (int layer = 0; layer < 2; ++layer)
    sum.add({.measured = measured, .truth = truth, .surfaces = surfaces});
  const report::Blame blame = sum.blame();
  EXPECT_NEAR(blame.mse, (0.25 + 0.0625 + 0.25) / 6, 1e-9);
  double total = 0;
  for (const auto& [cause, share] : blame.shares) total += share;
  EXPECT_NEAR(total, 1, 1e-9);
  ASSERT_EQ(blame.shares.size(), kCauses);
  EXPECT_EQ(blame.shares[0].first, "noise");

  const auto picture = sum.picture();
  ASSERT_EQ(picture.size(), 6u);
  EXPECT_GT(picture[0], picture[2]) << "leaking is yellow";
  EXPECT_GT(picture[4], picture[3]) << "the inner layer is green";
}

TEST(Blame, WhereOneOfTheTwoShowsNoSurfaceNothingCounts) {
  const std::vector<float> truth = {0, 0, 0, 0}, measured = {1, 1, 1, 1};
  const std::vector<uint8_t> surfaces = {1};
  BlameSum sum(1, 1);
  sum.add({.measured = measured, .truth = truth, .surfaces = surfaces});
  EXPECT_EQ(sum.blame().mse, 0);
}

}  // namespace
}  // namespace sb
