// Statistics of errors by hand, masks, layers added up, error maps.
#include "suites/metrics/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "suites/metrics/error_map.h"

namespace sb {
namespace {

TEST(Error, StatisticsOfFourPixels) {
  const std::vector<float> truth(16, 1.0f);
  //                                 r  g     b  alpha
  const std::vector<float> measured = {1, 1,    1, 1,   //
                                       1, 0.5f, 1, 1,   //
                                       0, 1,    2, 1,   //
                                       9, 9,    9, 0};  // no surface
  const report::ErrorStats e = errorOf(measured, truth);
  EXPECT_EQ(e.pixels, 3u);
  EXPECT_DOUBLE_EQ(e.rmse, std::sqrt((0.25 + 1 + 1) / 9));
  EXPECT_DOUBLE_EQ(e.bias, (-0.5 - 1 + 1) / 9);
  EXPECT_EQ(e.max, 1);
  EXPECT_EQ(e.p999, 1);
  EXPECT_DOUBLE_EQ(e.over1, 2.0 / 3);
  EXPECT_DOUBLE_EQ(e.rmseRgb[1], std::sqrt(0.25 / 3));
  EXPECT_DOUBLE_EQ(e.biasRgb[0], -1.0 / 3);

  const std::vector<uint8_t> mask = {0, 0, 1, 0};
  EXPECT_DOUBLE_EQ(errorOf(measured, truth, mask).max, 0.5);
  ErrorSum sum;
  sum.add(measured, truth, mask);
  sum.add(measured, truth);
  EXPECT_EQ(sum.stats().pixels, 5u);
  EXPECT_DOUBLE_EQ(sum.stats().rmse, std::sqrt((2 * 0.25 + 2) / 15));
}

TEST(Error, PixelsThatOneOfTheTwoAloneCoversAreCounted) {
  const std::vector<float> measured = {1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0};
  const std::vector<uint8_t> surfaces = {1, 0, 2, 0}, mask = {0, 1, 0, 0};
  EXPECT_EQ(oneSided(measured, surfaces), 2u);
  EXPECT_EQ(oneSided(measured, surfaces, mask), 1u);
}

TEST(Error, PercentileIsTheLeastValueThatAllButAThousandthKeepTo) {
  std::vector<float> truth, measured;
  for (int i = 1; i <= 2000; ++i) {
    truth.insert(truth.end(), {0, 0, 0, 1});
    measured.insert(measured.end(), {float(i), 0, -float(i) / 2, 1});
  }
  EXPECT_EQ(errorOf(measured, truth).p999, 1998);
}

TEST(Error, NothingToCompareIsNoError) {
  const std::vector<float> nowhere(8, 0.0f);
  EXPECT_EQ(errorOf(nowhere, nowhere).pixels, 0u);
  EXPECT_EQ(ErrorSum().stats().rmse, 0);
}

TEST(Error, WhatIsNotFiniteOrNotAlikeIsRefused) {
  const std::vector<float> one(4, 1.0f), two(8, 1.0f);
  EXPECT_THROW(errorOf(one, two), std::invalid_argument);
  EXPECT_THROW(errorOf(one, one, std::vector<uint8_t>(2)), std::invalid_argument);
  std::vector<float> broken = one;
  broken[1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(errorOf(broken, one), std::invalid_argument);
}

TEST(Error, OfAPictureCountsEveryPixelWhateverItsAlpha) {
  const report::Picture truth{2, 1, {0.5f, 0.5f, 0.5f, 1, 0, 0, 0, 0}};
  const report::Picture measured{2, 1, {0.5f, 0.5f, 0.5f, 0.25f, 0.1f, 0.1f, 0.1f, 1}};
  const report::ImageError e = imageError(measured, truth, std::vector<uint8_t>{0, 1});
  EXPECT_EQ(e.all.pixels, 2u);
  EXPECT_NEAR(e.relmse, 0.01 / 0.01 / 2, 1e-6);
  EXPECT_EQ(e.relmseInterior, 0);
  EXPECT_EQ(e.interior.pixels, 1u);
  EXPECT_EQ(e.interior.max, 0);
  EXPECT_GT(e.flip, 0);
}

double lightness(std::array<uint8_t, 3> c) {
  double y = 0;
  const double weights[3] = {0.2126, 0.7152, 0.0722};
  for (size_t i = 0; i < 3; ++i) {
    const double v = c[i] / 255.0;
    y += weights[i] * (v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
  }
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(ErrorMap, LightnessRisesAllAlongTheScale) {
  double before = -1;
  for (int i = 0; i <= 64; ++i) {
    const double l = lightness(scaleColor(float(i) / 64));
    EXPECT_GT(l, before) << i;
    before = l;
  }
  EXPECT_LT(lightness(scaleColor(0)), 5);
  EXPECT_GT(lightness(scaleColor(1)), 90);
}

TEST(ErrorMap, IsLogarithmicAndUpright) {
  // Two rows: the bottom one errs by 1, the top one by 1/32, half way down the scale of 1024.
  report::Picture truth{1, 2, std::vector<float>(8, 0.0f)}, measured = truth;
  measured.rgba[1] = 1;
  measured.rgba[4 + 2] = -1.0f / 32;
  const auto rgb = errorMap(measured, truth);
  const auto top = scaleColor(0.5f), bottom = scaleColor(1);
  for (size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(rgb[c], top[c]);
    EXPECT_EQ(rgb[3 + c], bottom[c]);
  }
}

}  // namespace
}  // namespace sb
