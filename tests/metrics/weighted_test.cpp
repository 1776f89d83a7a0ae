// Errors weighed by the light that they concern.
#include "suites/metrics/weighted.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sb {
namespace {

TEST(WeightedSum, AFaceThatALightGrazesHardlyCounts) {
  const std::vector<float> truth = {1, 1, 1, 1, 1, 1, 1, 1};
  const std::vector<float> measured = {1, 1, 1, 1, 0, 0, 0, 1};
  EXPECT_NEAR(errorOf(measured, truth).rmse, std::sqrt(0.5), 1e-7);
  WeightedSum sum;
  sum.add(measured, truth, std::vector<float>{0.99f, 0.01f});
  EXPECT_NEAR(*sum.rmse(), 0.1, 1e-6);
}

TEST(WeightedSum, EqualWeightsGiveThePlainErrorWhateverTheirScale) {
  const std::vector<float> truth = {0, 0.5f, 1, 1, 0.25f, 0, 0, 1, 0, 0, 0, 0};
  const std::vector<float> measured = {0.5f, 0.5f, 0, 1, 1, 0, 0.125f, 1, 1, 1, 1, 1};
  for (const float weight : {1e-6f, 1.0f, 7e4f}) {
    WeightedSum sum;
    sum.add(measured, truth, std::vector<float>(3, weight));
    EXPECT_NEAR(*sum.rmse(), errorOf(measured, truth).rmse, 1e-7);
  }
}

TEST(WeightedSum, AddsLightsAndLayersAndLeavesOutTheMasked) {
  const std::vector<float> truth = {1, 1, 1, 1}, wrong = {0, 0, 0, 1};
  WeightedSum sum;
  sum.add(wrong, truth, std::vector<float>{1});
  sum.add(truth, truth, std::vector<float>{3});
  EXPECT_NEAR(*sum.rmse(), 0.5, 1e-12);
  sum.add(wrong, truth, std::vector<float>{100}, std::vector<uint8_t>{1});
  EXPECT_NEAR(*sum.rmse(), 0.5, 1e-12);
  EXPECT_FALSE(WeightedSum().rmse());
  EXPECT_THROW(sum.add(wrong, truth, std::vector<float>{1, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace sb
