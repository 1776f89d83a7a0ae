// FLIP against an independent computation (tests/metrics/reference_flip.py: whole two-dimensional
// kernels in double precision), and its properties.
#include "suites/metrics/flip.h"

#include <gtest/gtest.h>

#include <numeric>

namespace sb {
namespace {

using report::Picture;

Picture filled(float r, float g, float b) {
  Picture p{24, 16, {}};
  for (int i = 0; i < 24 * 16; ++i) p.rgba.insert(p.rgba.end(), {r, g, b, 1});
  return p;
}

/// A gradient with a bar of a colour that begins at column `first`.
Picture bars(uint32_t first, float r, float g, float b) {
  Picture p{24, 16, {}};
  for (uint32_t y = 0; y < 16; ++y)
    for (uint32_t x = 0; x < 24; ++x)
      if (x >= first && x < first + 3)
        p.rgba.insert(p.rgba.end(), {r, g, b, 1});
      else
        p.rgba.insert(p.rgba.end(), {float(x) / 24, float(y) / 16, 0.25f, 1});
  return p;
}

double mean(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

TEST(Flip, EqualsTheIndependentComputation) {
  const auto f = flip(bars(8, 0.9f, 0.1f, 0.2f), bars(12, 0.1f, 0.6f, 0.9f));
  EXPECT_NEAR(mean(f), 0.359234, 1e-4);
  EXPECT_NEAR(f[3 * 24 + 4], 0.075298, 1e-4);
  EXPECT_NEAR(f[8 * 24 + 9], 0.961047, 1e-4);
  EXPECT_NEAR(f[15 * 24 + 13], 0.824726, 1e-4);
  const Picture grey = filled(0.5f, 0.5f, 0.5f);
  EXPECT_NEAR(mean(flip(grey, filled(0.6f, 0.6f, 0.6f))), 0.196212, 1e-4);
  EXPECT_NEAR(mean(flip(grey, filled(0.6f, 0.5f, 0.5f))), 0.199460, 1e-4);
  EXPECT_NEAR(mean(flip(grey, filled(0, 0, 0))), 0.958542, 1e-4);
  EXPECT_NEAR(mean(flip(filled(1, 1, 1), filled(0, 0, 0))), 0.967379, 1e-4);
  EXPECT_NEAR(mean(flip(filled(0, 0, 1), filled(0, 1, 0))), 1.0, 1e-4);
}

TEST(Flip, IsSymmetricAndZeroForEqualPictures) {
  const Picture a = bars(8, 0.9f, 0.1f, 0.2f), b = bars(12, 0.1f, 0.6f, 0.9f);
  EXPECT_EQ(flip(a, b), flip(b, a));
  for (const float f : flip(a, a)) EXPECT_EQ(f, 0);
  for (const float f : flip(a, b)) EXPECT_TRUE(f >= 0 && f <= 1) << f;
}

TEST(Flip, SeesThePictureAsItsFileShowsIt) {
  // Beyond white is white.
  EXPECT_EQ(mean(flip(filled(1, 1, 1), filled(7, 1, 2))), 0);
}

TEST(Flip, RefusesOtherSizes) {
  Picture small{1, 1, {0, 0, 0, 1}};
  EXPECT_THROW(flip(small, filled(0, 0, 0)), std::invalid_argument);
}

}  // namespace
}  // namespace sb
