// Regions by the truth, with errors and noise computed by hand.
#include "suites/metrics/regions.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sb {
namespace {

Region of(float r, float g, float b) {
  const float rgb[3] = {r, g, b};
  return regionOf(rgb);
}

TEST(Regions, FollowFromTheTruth) {
  EXPECT_EQ(of(0, 0, 0), Region::Dark);
  EXPECT_EQ(of(0.05f, 0, 0.01f), Region::Dark);  // dark though saturated
  EXPECT_EQ(of(0.06f, 0, 0), Region::Saturated);
  EXPECT_EQ(of(1, 0.4f, 0.9f), Region::Saturated);
  EXPECT_EQ(of(1, 0.5f, 0.5f), Region::Pale);  // half is not more than half
  EXPECT_EQ(of(0.3f, 0.3f, 0.3f), Region::Pale);
  EXPECT_EQ(of(1, 1, 0.99f), Region::Pale);
  EXPECT_EQ(of(1, 1, 1), Region::Lit);
}

TEST(Regions, SumErrorsAndNoiseByHand) {
  // Dark, saturated, pale, an edge, a pixel without a surface, pale.
  const std::vector<float> truth = {0, 0, 0, 1, 1, 0, 0, 1, 0.5f, 0.5f, 0.5f, 1,
                                    1, 1, 1, 1, 0, 0, 0, 0, 0.5f, 0.5f, 0.5f, 1};
  const std::vector<float> measured = {0.3f, 0, 0, 1, 1, 0, 0, 1, 0.75f, 0.5f, 0.5f, 1,
                                       0,    0, 0, 1, 9, 9, 9, 0, 0.25f, 0.5f, 0.5f, 1};
  const std::vector<uint8_t> mask = {0, 0, 0, 1, 0, 0};
  std::vector<float> variance(24, 0.0f);
  variance[0] = 0.03f;                        // dark
  variance[8] = 0.25f, variance[21] = 0.25f;  // pale
  variance[12] = 100;                         // behind the mask
  variance[3] = 100;                          // no channel
  RegionSum sum;
  sum.add(measured, truth, mask, variance);
  const auto regions = sum.regions();
  ASSERT_EQ(regions.size(), 3u);
  EXPECT_EQ(regions[0].region, "dark");
  EXPECT_DOUBLE_EQ(regions[0].share, 0.25);
  EXPECT_NEAR(regions[0].rmse, 0.3 / std::sqrt(3), 1e-7);
  EXPECT_NEAR(regions[0].bias, 0.1, 1e-7);
  EXPECT_NEAR(*regions[0].noise, 0.1, 1e-7);
  EXPECT_EQ(regions[1].region, "saturated");
  EXPECT_EQ(regions[1].rmse, 0);
  EXPECT_EQ(regions[1].noise, 0);
  EXPECT_EQ(regions[2].region, "pale");
  EXPECT_DOUBLE_EQ(regions[2].share, 0.5);
  EXPECT_NEAR(regions[2].rmse, 0.25 / std::sqrt(3), 1e-7);
  EXPECT_EQ(regions[2].bias, 0);
  EXPECT_NEAR(*regions[2].noise, std::sqrt(0.5 / 6), 1e-7);
}

TEST(Regions, WithoutSeedsThereIsNoNoise) {
  const std::vector<float> lit = {1, 1, 1, 1};
  RegionSum sum;
  sum.add(lit, lit, {}, {});
  sum.add(lit, lit, {}, {});  // a second light
  ASSERT_EQ(sum.regions().size(), 1u);
  EXPECT_EQ(sum.regions()[0].region, "lit");
  EXPECT_EQ(sum.regions()[0].share, 1);
  EXPECT_FALSE(sum.regions()[0].noise.has_value());
  EXPECT_THROW(sum.add(lit, {}, {}, {}), std::invalid_argument);
  EXPECT_TRUE(RegionSum().regions().empty());
}

}  // namespace
}  // namespace sb
