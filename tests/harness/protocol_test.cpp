// The rules of measuring without a clock.
#include "suites/harness/measuring/protocol.h"

#include <gtest/gtest.h>

#include <limits>

#include "suites/harness/checks/load_watch.h"

namespace sb {
namespace {

TEST(Protocol, WarmUpEndsWhenTwoWindowsAgree) {
  WarmUp rule;
  EXPECT_FALSE(rule.add(400)) << "one window agrees with nothing";
  EXPECT_FALSE(rule.add(20));
  EXPECT_FALSE(rule.add(12));
  EXPECT_TRUE(rule.add(11));
  EXPECT_TRUE(rule.steady());
  EXPECT_EQ(rule.windows(), 4);
}

TEST(Protocol, WarmUpGivesUpAfterTenWindows) {
  WarmUp rule;
  for (int w = 1; w < WarmUp::kMaxWindows; ++w) ASSERT_FALSE(rule.add(w % 2 ? 10 : 20));
  EXPECT_TRUE(rule.add(20));
  EXPECT_FALSE(rule.steady());
}

TEST(Protocol, WarmUpForgivesWhatClocksCost) {
  WarmUp rule;
  rule.add(0.01);
  EXPECT_TRUE(rule.add(0.05)) << "0.04 ms apart";
}

TEST(Protocol, RoundsRunForthAndBack) {
  EXPECT_EQ(roundOrder(3, 0), (std::vector<size_t>{0, 1, 2}));
  EXPECT_EQ(roundOrder(3, 1), (std::vector<size_t>{2, 1, 0}));
  EXPECT_EQ(roundOrder(3, 2), roundOrder(3, 0));
  EXPECT_TRUE(roundOrder(0, 0).empty());
}

TEST(Protocol, StopsByPrecisionBeforeBudget) {
  const StopRule rule = {.precision = 0.05, .minBlocks = 6, .repetitions = 0};
  const double wide[] = {0.01, 0.3}, narrow[] = {0.01, 0.05};
  EXPECT_EQ(stopNow(rule, 5, 9, narrow), Stop::Not) << "too few for an interval";
  EXPECT_EQ(stopNow(rule, 6, 0.1, narrow), Stop::Precision);
  EXPECT_EQ(stopNow(rule, 6, 0.1, wide), Stop::Not);
  EXPECT_EQ(stopNow(rule, 6, 1.0, wide), Stop::Budget);
  EXPECT_EQ(stopNow(rule, 6, 1.0, narrow), Stop::Precision);
  EXPECT_EQ(stopNow(rule, 6, 0.1, {}), Stop::Precision) << "no cell is left";
}

TEST(Protocol, RepetitionsOverrideBoth) {
  const StopRule rule = {.precision = 1, .minBlocks = 6, .repetitions = 3};
  EXPECT_EQ(stopNow(rule, 2, 99, {}), Stop::Not);
  EXPECT_EQ(stopNow(rule, 3, 0, {}), Stop::Repetitions);
}

TEST(Protocol, HalfWidthIsOfTheMediansInterval) {
  // Six samples: the interval is the whole range.
  EXPECT_NEAR(relativeHalfWidth(std::vector<double>{8, 9, 10, 10, 11, 12}), 0.2, 1e-12);
  EXPECT_EQ(relativeHalfWidth({}), 0);
}

TEST(LoadWatch, CountsOthersAgainstTheWholeMachine) {
  const MachineUse before = {.total = 100, .busy = 40, .own = 10, .throttled = 3};
  MachineUse after = {.total = 120, .busy = 59, .own = 20, .throttled = 3};
  EXPECT_TRUE(disturbances(before, after).empty()) << "45 % went to others";
  after.own = 15;
  ASSERT_EQ(disturbances(before, after).size(), 1u);
  EXPECT_EQ(disturbances(before, after)[0], "other programs used 70 % of the CPUs");
  after.own = 29;
  after.throttled = 4;
  EXPECT_EQ(disturbances(before, after), std::vector<std::string>{"the CPU was throttled"});
  after.throttled = {};
  EXPECT_TRUE(disturbances(before, after).empty());
}

TEST(LoadWatch, ReadsThisMachine) {
  const MachineUse use = machineUse();
  EXPECT_GT(use.total, use.busy);
  EXPECT_GT(use.busy, 0);
  EXPECT_GT(use.own, 0);
}

}  // namespace
}  // namespace sb
