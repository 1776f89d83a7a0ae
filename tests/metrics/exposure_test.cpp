// Automatic exposure.
#include "suites/metrics/exposure.h"

#include <gtest/gtest.h>

#include "suites/metrics/error.h"

namespace sb {
namespace {

report::Picture grey(std::initializer_list<float> values) {
  report::Picture p{.width = uint32_t(values.size()), .height = 1};
  for (const float v : values) p.rgba.insert(p.rgba.end(), {v, v, v, 1});
  return p;
}

TEST(Exposure, TakesPhysicalUnitsToMiddleGreyInWholeStops) {
  // 0.18 / 12000 lies next to 2^-16.
  EXPECT_EQ(automaticExposure(grey({12000, 12000})), 0x1p-16f);
  EXPECT_EQ(automaticExposure(grey({6000, 24000})), 0x1p-16f) << "the mean of logarithms";
  EXPECT_EQ(automaticExposure(grey({12000, 0, 0, 0})), 0x1p-16f) << "black does not count";
  EXPECT_EQ(automaticExposure(grey({1e-4f})), 0x1p+11f);
}

TEST(Exposure, LeavesWhatIsLitForDisplay) {
  for (const float v : {0.03f, 0.18f, 1.0f, 1.4f}) EXPECT_EQ(automaticExposure(grey({v})), 1) << v;
  EXPECT_EQ(automaticExposure(grey({0, 0})), 1);
  EXPECT_EQ(automaticExposure({}), 1);
  EXPECT_EQ(automaticExposure(grey({std::numeric_limits<float>::infinity()})), 1);
}

TEST(Exposure, ShadowsInPhysicalUnitsAreSeen) {
  const report::Picture lit = grey({68300, 68300, 68300, 68300});
  report::Picture shadowed = lit;
  for (size_t i = 0; i < 8; ++i) shadowed.rgba[i] *= i % 4 == 3 ? 1.0f : 0.1f;
  EXPECT_EQ(imageError(shadowed, lit, {}).flip, 0) << "all white as it comes";
  const float e = automaticExposure(lit);
  EXPECT_GT(imageError(exposed(shadowed, e), exposed(lit, e), {}).flip, 0.1);
}

}  // namespace
}  // namespace sb
