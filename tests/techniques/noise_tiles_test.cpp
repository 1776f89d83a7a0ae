// Tiles of noise: contents, and what makes blue noise blue.
#include "techniques/maps/noise_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sb {
namespace {

TEST(NoiseTiles, WhiteHoldsOneNumberOfEachPart) {
  std::vector<float> sorted = whiteTile();
  ASSERT_EQ(sorted.size(), size_t(kWhiteWidth) * kWhiteWidth);
  // In an order that no neighbour knows: correlation along a row within 4 sigma of none.
  double sum = 0;
  for (size_t i = 0; i + 1 < sorted.size(); ++i) sum += (sorted[i] - 0.5) * (sorted[i + 1] - 0.5);
  EXPECT_NEAR(12 * sum / double(sorted.size()), 0, 4 / std::sqrt(double(sorted.size())));
  std::ranges::sort(sorted);
  for (size_t i = 0; i < sorted.size(); ++i) {
    ASSERT_EQ(size_t(sorted[i] * 65536.0f), i);
    ASSERT_EQ(sorted[i] * 0x1p24f, std::floor(sorted[i] * 0x1p24f)) << "24 bits";
  }
  EXPECT_LT(sorted.back(), 1);
}

TEST(NoiseTiles, BlueHoldsEveryRankOnce) {
  std::vector<float> sorted = blueTile();
  std::ranges::sort(sorted);
  ASSERT_EQ(sorted.size(), size_t(kBlueWidth) * kBlueWidth);
  for (size_t i = 0; i < sorted.size(); ++i) ASSERT_EQ(sorted[i], float(i) / 4096);
}

TEST(NoiseTiles, BlueHasNoLowFrequencies) {
  // Texels below a threshold, counted in blocks of 8 x 8 anywhere on the torus: white noise has the
  // variance 64 q (1 - q).
  const std::vector<float>& tile = blueTile();
  for (const double q : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    double squares = 0;
    for (uint32_t y0 = 0; y0 < kBlueWidth; ++y0)
      for (uint32_t x0 = 0; x0 < kBlueWidth; ++x0) {
        double count = 0;
        for (uint32_t i = 0; i < 64; ++i)
          count += tile[(y0 + i / 8) % kBlueWidth * kBlueWidth + (x0 + i % 8) % kBlueWidth] < q;
        squares += (count - 64 * q) * (count - 64 * q);
      }
    EXPECT_LT(squares / 4096 / (64 * q * (1 - q)), 0.2) << q;
  }
}

TEST(NoiseTiles, SourceHasAll256Levels) {
  const std::vector<uint8_t>& tile = sourceTile();
  ASSERT_EQ(tile.size(), 4u * kSourceWidth * kSourceWidth);
  std::vector<double> counts(256);
  for (const uint8_t v : tile) ++counts[v];
  const double expected = double(tile.size()) / 256;
  for (const double c : counts) EXPECT_NEAR(c, expected, 5 * std::sqrt(expected));
}

}  // namespace
}  // namespace sb
