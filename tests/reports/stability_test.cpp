// Verdicts of hard cases, their table and their JSON.
#include <gtest/gtest.h>

#include <cmath>

#include "reports/console/console_stability.h"
#include "reports/json/json.h"
#include "reports/json/json_read.h"
#include "reports/stability_record.h"

using namespace report;

namespace {

StabilityRecord record(const std::string& id, const std::string& technique,
                       std::vector<StabilityPoint> curve, const std::string& expected = "") {
  StabilityRecord r{.id = id,
                    .title = "Title",
                    .property = "property (unit)",
                    .reason = "reason",
                    .technique = technique,
                    .backend = "vulkan",
                    .parameter = "angle",
                    .logarithmic = true,
                    .curve = std::move(curve)};
  judge(r, expected);
  return r;
}

TEST(Stability, VerdictsFollowFromTheCurve) {
  EXPECT_EQ(record("A", "T", {{1, 0.5, 0.5}, {2, 0, 0}}).verdict, Verdict::Pass);
  const StabilityRecord fails = record("A", "T", {{1, 0, 0}, {2, 0.25, 0.125}, {3, 1, 0.125}});
  EXPECT_EQ(fails.verdict, Verdict::Fail);
  EXPECT_EQ(fails.breaksAt, 2);
  EXPECT_EQ(fails.worst()->x, 3);
  const StabilityRecord known = record("A", "T", {{1, 1, 0}}, "by construction");
  EXPECT_EQ(known.verdict, Verdict::Expected);
  EXPECT_EQ(known.why, "by construction");
  // An excuse that is not needed is none.
  EXPECT_EQ(record("A", "T", {{1, 0, 0}}, "by construction").why, "");
  EXPECT_EQ(record("A", "T", {}).verdict, Verdict::Skipped);
}

TEST(Stability, WhatIsNoNumberExceedsEverything) {
  const StabilityRecord r = record("A", "T", {{1, 0.5, 1}, {2, std::nan(""), 1}});
  EXPECT_EQ(r.verdict, Verdict::Fail);
  EXPECT_EQ(r.breaksAt, 2);
  EXPECT_EQ(r.worst()->x, 2);
}

TEST(Stability, TableShowsTheWorstOfAllApis) {
  std::vector<StabilityRecord> all = {record("A", "T", {{1, 0, 0}}), record("A", "T", {{1, 1, 0}}),
                                      record("B", "U", {{3, 1, 0}}, "known")};
  all[1].backend = "opengl";
  EXPECT_EQ(toTable(all),
            "hard case  T         U\n"
            "A          FAIL 1/2\n"
            "B                    EXPECTED\n"
            "3 hard cases: 1 pass, 1 break as expected by construction, 1 fail, 0 skipped\n"
            "EXPECTED  B/U/vulkan: property (unit)\n"
            "          found 1, allowed 0 at angle = 3; breaks at 3\n"
            "          known\n"
            "FAIL      A/T/opengl: property (unit)\n"
            "          found 1, allowed 0 at angle = 1; breaks at 1\n"
            "          beyond the tolerance\n");
  EXPECT_EQ(toTable(std::vector<StabilityRecord>{}), "");
}

TEST(Stability, JsonIsReadBackWhole) {
  report::Run run;
  run.stability = {record("A", "T", {{1, 0.25, 0.5}, {2, std::nan(""), 1}}),
                   record("B", "U+V", {{1, 1, 0}}, "known"), record("C", "T", {})};
  const report::Run back = fromJson(toJson(run), "run.json");
  ASSERT_EQ(back.stability.size(), 3u);
  for (size_t i = 0; i < 3; ++i) {
    const StabilityRecord &a = run.stability[i], &b = back.stability[i];
    EXPECT_EQ(
        a.id + a.title + a.property + a.reason + a.technique + a.backend + a.parameter + a.why,
        b.id + b.title + b.property + b.reason + b.technique + b.backend + b.parameter + b.why);
    EXPECT_EQ(a.verdict, b.verdict);
    EXPECT_EQ(a.breaksAt, b.breaksAt);
    EXPECT_EQ(a.logarithmic, b.logarithmic);
    ASSERT_EQ(a.curve.size(), b.curve.size());
    for (size_t k = 0; k < a.curve.size(); ++k) {
      EXPECT_EQ(a.curve[k].x, b.curve[k].x);
      EXPECT_EQ(a.curve[k].tolerance, b.curve[k].tolerance);
      EXPECT_TRUE(a.curve[k].value == b.curve[k].value ||
                  (std::isnan(a.curve[k].value) && std::isnan(b.curve[k].value)));
    }
  }
}

}  // namespace
