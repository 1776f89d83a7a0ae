// Text becomes a number whole and unchanged, or not at all.
#include "base/number.h"

#include <gtest/gtest.h>

#include <cmath>

namespace base {
namespace {

TEST(Number, AllOfTheTextCounts) {
  for (const char* text : {"", " 1", "1 ", "+1", "0x10", "1,5", "1e", "one", "1x", "nan", "inf",
                           "-inf", "1e400", "-1e400", "1e-400", "--1", "1\n", "\xff"})
    EXPECT_FALSE(readNumber(text, {})) << text;
  EXPECT_EQ(readNumber("-1.5e3", {}), -1500.0);
  EXPECT_FALSE(std::signbit(*readNumber("-0", {})));
}

TEST(Number, RulesHold) {
  const NumberRule seeds{.low = 1, .high = 65536, .whole = true};
  for (const char* text : {"0", "0.5", "1.5", "1e300", "65537", "4294967297", "-1"})
    EXPECT_FALSE(readNumber(text, seeds)) << text;
  EXPECT_EQ(readNumber("65536", seeds), 65536.0);
  EXPECT_EQ(describe(seeds), "a whole number from 1 to 65536");
  const NumberRule positive{.low = 0, .above = true};
  EXPECT_FALSE(readNumber("0", positive));
  EXPECT_EQ(readNumber("1e-300", positive), 1e-300);
  EXPECT_EQ(describe(positive), "a number above 0");
  const NumberRule odd{.low = 1, .high = 9, .odd = true};
  EXPECT_FALSE(readNumber("4", odd));
  EXPECT_FALSE(readNumber("3.5", odd));
  EXPECT_TRUE(readNumber("3", odd));
}

TEST(Number, WholeNumbersDoNotWrap) {
  EXPECT_FALSE(readWhole("4294967297", 0, UINT32_MAX));
  EXPECT_FALSE(readWhole("18446744073709551616", 0, UINT64_MAX));
  EXPECT_FALSE(readWhole("-1", 0, UINT64_MAX));
  EXPECT_FALSE(readWhole("1e2", 0, UINT64_MAX));
  EXPECT_EQ(readWhole("18446744073709551615", 0, UINT64_MAX), UINT64_MAX);
}

TEST(Number, Sizes) {
  for (const char* text : {"", "x", "1", "1x", "x1", "0x1", "1x0", "1x1x1", "1x1 ", "16385x1",
                           "4294967297x4294967297", "-1x1", "1.5x1", "1X1", "1e2x1"})
    EXPECT_FALSE(readSize(text)) << text;
  EXPECT_EQ(readSize("16384x1"), std::pair(16384u, 1u));
}

}  // namespace
}  // namespace base
