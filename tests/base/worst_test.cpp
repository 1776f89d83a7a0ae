#include "base/worst.h"

#include <gtest/gtest.h>

#include <limits>

namespace sb::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(Worst, IsTheLarger) {
  EXPECT_EQ(base::worse(1.0, 2.0), 2);
  EXPECT_EQ(base::worse(2.0, -3.0), 2);
}

TEST(Worst, NoNumberStays) {
  EXPECT_TRUE(std::isnan(base::worse(0.0, kNaN)));
  EXPECT_TRUE(std::isnan(base::worse(kNaN, 0.0)));
  EXPECT_TRUE(std::isnan(base::worse(base::worse(0.0, kNaN), 5.0)));
}

}  // namespace
}  // namespace sb::test
