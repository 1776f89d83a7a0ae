// Patterns match in linear time, whatever they are.
#include "base/pattern.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace base {
namespace {

TEST(Pattern, RegexIsFoundAnywhere) {
  EXPECT_TRUE(Pattern::regex("b.d").found("abcde"));
  EXPECT_TRUE(Pattern::regex("").found("anything"));
  EXPECT_FALSE(Pattern::regex("^b").found("abc"));
  EXPECT_THROW(Pattern::regex("("), std::invalid_argument);
  EXPECT_THROW(Pattern::regex("(a)\\1"), std::invalid_argument);
}

TEST(Pattern, GlobIsTheWholeName) {
  EXPECT_TRUE(Pattern::glob("fabric*").found("fabric.red"));
  EXPECT_FALSE(Pattern::glob("fabric").found("fabric.red"));
  EXPECT_TRUE(Pattern::glob("?.[x]").found("a.[x]"));
  EXPECT_FALSE(Pattern::glob("?.[x]").found("a-x"));
  EXPECT_FALSE(Pattern::glob("?").found(""));
  EXPECT_TRUE(Pattern::glob("*").found(""));
  EXPECT_TRUE(Pattern::glob("a?b").found("a\nb"));
  EXPECT_TRUE(Pattern::glob("caf?").found("caf\xc3\xa9"));  // one character, two bytes
  EXPECT_TRUE(Pattern::glob("x\xff*").found("x\xff\xfe"));
}

// A backtracking engine needs 2^30 steps or a deep stack for these.
TEST(Pattern, NothingRunsForEver) {
  const std::string many(30, 'a'), long_(1 << 20, 'a');
  EXPECT_FALSE(Pattern::regex("(a*)*b").found(many));
  EXPECT_FALSE(Pattern::regex("(a|aa)+$").found(many + "b"));
  EXPECT_FALSE(Pattern::regex("(.*)*x$").found(long_));
  std::string stars;
  for (int i = 0; i < 40; ++i) stars += "*a";
  EXPECT_FALSE(Pattern::glob(stars + "b").found(long_));
  EXPECT_THROW(Pattern::regex(std::string(100000, '(')), std::invalid_argument);
}

}  // namespace
}  // namespace base
