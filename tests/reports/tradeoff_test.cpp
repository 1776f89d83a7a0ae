// Which cells become points of which trade-off, the front among them, and the tables of limits:
// every expectation is worked out by hand. The type Run is spelled out, as GoogleTest has a Run of
// its own within a test.
#include "reports/stats/tradeoff.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/reports/tradeoff_cells.h"

namespace report {
namespace {

std::vector<std::string> techniques(const TradeOff& t) {
  std::vector<std::string> names;
  for (const TradePoint& p : t.points) names.push_back(p.technique);
  return names;
}

/// "F" on the front, "?" uncertain, "." behind.
std::string marks(const std::vector<Record>& records) {
  const report::Run run = {.records = records};
  std::string out;
  const std::vector<TradeOff> all = tradeOffs(run);
  for (const TradePoint& p : all.at(0).points)
    out += p.uncertain ? '?' : (p.front ? 'F' : '.');
  return out;
}

Record with(Record r, auto change) {
  change(r);
  return r;
}

Record spreadCell(double time, double timeSpread, double error, double errorSpread) {
  Record r = cell("A", time, error);
  spread(r, timeSpread);
  noisy(r, error - errorSpread, error + errorSpread);
  return r;
}

TEST(TradeOff, TimeIsOfTheCpuOnSoftwareDevicesAndOfTheFrameElsewhere) {
  Record soft = cell("A", 3, 0.5);
  spread(soft, 1);
  Record hard = with(soft, [](Record& r) { r.deviceType = "discrete", r.device = "card"; });
  const report::Run run = {.records = {soft, hard}};
  const auto all = tradeOffs(run);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].timeKey, "cpu_ms");
  EXPECT_EQ(all[0].points.at(0).time, 3);
  EXPECT_EQ(all[0].points.at(0).timeInterval.low, 2);
  EXPECT_EQ(all[0].points.at(0).timeInterval.high, 4);
  EXPECT_EQ(all[1].timeKey, "frame_ms");
  EXPECT_EQ(all[1].points.at(0).time, 6);
  EXPECT_EQ(all[1].points.at(0).timeInterval.low, 4);
  EXPECT_EQ(all[1].points.at(0).timeInterval.high, 8);
  EXPECT_EQ(all[1].points.at(0).record, &run.records[1]);
  EXPECT_EQ(all[1].points.at(0).bytes, 1u << 20);
}

TEST(TradeOff, ErrorIsOfTheKindAskedForAndOnlyVisibilityHasAnInterval) {
  report::Run run = {.records = {cell("A", 3, 0.5), cell("B", 3, 0.5)}};
  noisy(run.records[0], 0.25, 0.75);
  const auto visibility = tradeOffs(run).at(0).points;
  EXPECT_EQ(visibility[0].error, 0.5);
  EXPECT_EQ(visibility[0].errorInterval.low, 0.25);
  EXPECT_EQ(visibility[0].errorInterval.high, 0.75);
  EXPECT_EQ(visibility[1].errorInterval.low, 0.5);
  EXPECT_EQ(visibility[1].errorInterval.high, 0.5);
  const auto image = tradeOffs(run, ErrorKind::Image).at(0).points;
  EXPECT_EQ(image[0].error, 0.25);
  EXPECT_EQ(image[0].errorInterval.low, 0.25);
  EXPECT_EQ(image[0].errorInterval.high, 0.25);
}

// The interval is of a median over seeds; the point is one seed.
TEST(TradeOff, IntervalsHoldTheirPoint) {
  report::Run run = {.records = {cell("A", 3, 0.5)}};
  noisy(run.records[0], 0.6, 0.7);
  run.records[0].blocks = {{.frames = 1, .frameMs = 9, .cpuMs = 5}};
  const auto points = tradeOffs(run).at(0).points;
  EXPECT_EQ(points[0].errorInterval.low, 0.5);
  EXPECT_EQ(points[0].errorInterval.high, 0.7);
  EXPECT_EQ(points[0].timeInterval.low, 3);
  EXPECT_EQ(points[0].timeInterval.high, 5);
}

TEST(TradeOff, LeavesOutWhatCannotBeCompared) {
  const Record good = cell("good", 2, 0.25);
  const report::Run run = {.records = {
                               with(good, [](Record& r) { r.contamination = {"other programs"}; }),
                               with(good, [](Record& r) { r.visibility.reset(); }),
                               with(good, [](Record& r) { r.status = Status::Skipped; }),
                               with(good, [](Record& r) { refuse(r, "differs"); }),
                               with(good, [](Record& r) { r.cpu.reset(); }),
                               with(good, [](Record& r) { r.cpu->median = 0; }),
                               with(good, [](Record& r) { r.visibility->all.rmse = std::nan(""); }),
                           }};
  EXPECT_TRUE(tradeOffs(run).empty());
  EXPECT_TRUE(tradeOffs(run, ErrorKind::Image).size() == 1u) << "two have an image's error";
  const report::Run nothing;
  EXPECT_TRUE(tradeOffs(nothing).empty());
}

TEST(TradeOff, OneForEachSceneSizeBackendAndDevice) {
  const Record a = cell("A", 2, 0.25);
  const report::Run run = {.records = {a, with(a, [](Record& r) { r.id.scene = "other"; }),
                                       with(a, [](Record& r) { r.id.width = 1; }),
                                       with(a, [](Record& r) { r.id.height = 1; }),
                                       with(a, [](Record& r) { r.id.backend = "opengl"; }),
                                       with(a, [](Record& r) { r.device = "another"; }), a}};
  const auto all = tradeOffs(run);
  ASSERT_EQ(all.size(), 6u);
  EXPECT_EQ(all[0].points.size(), 2u);
  for (size_t i = 1; i < 6; ++i) EXPECT_EQ(all[i].points.size(), 1u);
  EXPECT_EQ(all[1].scene, "other");
  EXPECT_EQ(all[4].backend, "opengl");
}

TEST(TradeOff, TheTracerJoinsWhereCpuTimeComparesAndElseStandsAlone) {
  const Record a = cell("A", 2, 0.25);
  const Record gl = with(a, [](Record& r) { r.id.backend = "opengl"; });
  const Record card = with(a, [](Record& r) { r.deviceType = "discrete", r.device = "card"; });
  const Record other = with(a, [](Record& r) { r.id.scene = "other"; });
  const report::Run joined = {.records = {tracer(9), a, gl, card, other}};
  const auto all = tradeOffs(joined);
  ASSERT_EQ(all.size(), 4u);
  const std::vector<std::string> both = {"RayTraced", "A"}, one = {"A"};
  EXPECT_EQ(techniques(all[0]), both);
  EXPECT_EQ(all[0].backend, "vulkan");
  EXPECT_EQ(techniques(all[1]), both);
  EXPECT_EQ(techniques(all[2]), one) << "GPU time against CPU time";
  EXPECT_EQ(techniques(all[3]), one) << "another scene";
  const report::Run alone = {.records = {tracer(9), card, tracer(8)}};
  ASSERT_EQ(tradeOffs(alone).size(), 2u);
  EXPECT_EQ(tradeOffs(alone)[1].backend, "cpu");
  EXPECT_EQ(tradeOffs(alone)[1].points.size(), 2u);
}

TEST(TradeOff, TransparenciesAndLoopsOverLightsAreToldApart) {
  const Record a = cell("A", 2, 0.25);
  const report::Run run = {
      .records = {a, with(a, [](Record& r) { r.id.transparency = "Weighted"; }),
                  with(a, [](Record& r) { r.id.lights = "Clustered"; }), tracer(9)}};
  const TradeOff t = std::move(tradeOffs(run).at(0));
  EXPECT_EQ(t.techniques,
            (std::vector<std::string>{"A", "A+Weighted", "A@Clustered", "RayTraced"}));
}

TEST(TradeOff, FrontIsWhatNothingDominates) {
  // By hand: (1, .5) fastest; (2, .25) on the front; (2, .3) slower than none but less exact than
  // its neighbour; (3, .25) slower at the same error; (4, .1) most exact.
  EXPECT_EQ(marks({cell("A", 1, 0.5), cell("A", 2, 0.25), cell("A", 2, 0.3), cell("A", 3, 0.25),
                   cell("A", 4, 0.1)}),
            "FF..F");
  EXPECT_EQ(marks({cell("A", 1, 0)}), "F");
  EXPECT_EQ(marks({cell("A", 1, 0.5), cell("A", 1, 0.5)}), "FF") << "neither is better";
}

TEST(TradeOff, WellSeparatedPointsOfTheFrontAreCertain) {
  EXPECT_EQ(marks({spreadCell(1, 0.2, 0.5, 0.1), spreadCell(2, 0.2, 0.25, 0.1)}), "FF");
  // Times overlap, errors do not: the slower may be as fast, and is more exact for sure.
  EXPECT_EQ(marks({spreadCell(1, 0.5, 0.5, 0.1), spreadCell(1.5, 0.5, 0.25, 0.1)}), "?F");
  // Errors overlap, times do not.
  EXPECT_EQ(marks({spreadCell(1, 0.2, 0.5, 0.2), spreadCell(2, 0.2, 0.25, 0.2)}), "F?");
  EXPECT_EQ(marks({spreadCell(1, 0.5, 0.5, 0.2), spreadCell(1.5, 0.5, 0.25, 0.2)}), "??");
}

TEST(TradeOff, UncertainNeedsOneThatMayBeBetterInBothAtOnce) {
  // Beside the first point, the second may be as fast and the third as exact; neither may be both.
  // The first may be both beside either of them.
  EXPECT_EQ(marks({spreadCell(2, 0.5, 0.5, 0.1), spreadCell(1.5, 0.5, 0.9, 0.1),
                   spreadCell(9, 0.5, 0.45, 0.1)}),
            "F??");
  // Equal errors without spread, times that overlap: either may be the faster.
  EXPECT_EQ(marks({spreadCell(2, 0.5, 0.5, 0), spreadCell(2.25, 0.5, 0.5, 0)}), "?.");
  // Intervals that only touch leave no room to be better.
  EXPECT_EQ(marks({spreadCell(2, 0, 0.5, 0), spreadCell(2, 0, 0.5, 0)}), "FF");
}

TEST(TradeOff, EqualTimeTakesTheLeastErrorWithinMultiplesOfTheBaseline) {
  const report::Run run = {.records = {baseline(2, 0.5), cell("A", 4, 0.25), cell("A", 8.5, 0.1),
                                       cell("A", 7, 0.3), cell("B", 33, 0.01)}};
  const TradeOff t = std::move(tradeOffs(run).at(0));
  EXPECT_EQ(t.baseline, 2.0);
  EXPECT_EQ(t.techniques, (std::vector<std::string>{"none", "A", "B"}));
  ASSERT_EQ(t.equalTime.size(), 5u);
  const double limits[] = {1, 2, 4, 8, 16};
  const TradePoint* none = &t.points[0];
  // 2 x is 4 ms and takes the cell at 4; 4 x is 8 ms, where the cell at 7 is worse than that at 4.
  const TradePoint* ofA[] = {nullptr, &t.points[1], &t.points[1], &t.points[2], &t.points[2]};
  for (size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(t.equalTime[i].limit, limits[i]);
    ASSERT_EQ(t.equalTime[i].cells.size(), 3u);
    EXPECT_EQ(t.equalTime[i].cells[0].point, none);
    EXPECT_EQ(t.equalTime[i].cells[1].technique, "A");
    EXPECT_EQ(t.equalTime[i].cells[1].point, ofA[i]) << limits[i];
    EXPECT_EQ(t.equalTime[i].cells[2].point, nullptr) << "33 ms is over 16 x 2 ms";
  }
}

TEST(TradeOff, EqualErrorTakesTheFastestWithinEachError) {
  const report::Run run = {.records = {cell("A", 2, 0.1), cell("A", 5, 0.02), cell("A", 4, 0.025),
                                       cell("A", 4, 0.021), cell("A", 9, 0.01), tracer(50)}};
  const TradeOff t = std::move(tradeOffs(run).at(0));
  ASSERT_EQ(t.equalError.size(), 4u);
  const double limits[] = {1e-1, 3e-2, 1e-2, 3e-3};
  // Of the two at 4 ms the more exact.
  const TradePoint* ofA[] = {&t.points[0], &t.points[3], &t.points[4], nullptr};
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(t.equalError[i].limit, limits[i]);
    EXPECT_EQ(t.equalError[i].cells.at(0).point, ofA[i]) << limits[i];
    EXPECT_EQ(t.equalError[i].cells.at(1).point, &t.points[5]);
  }
}

TEST(TradeOff, BaselineNeedsATimeButNoError) {
  report::Run run = {.records = {baseline(3, 0.5), baseline(2, 0.5), cell("A", 4, 0.25)}};
  run.records[1].visibility.reset();
  EXPECT_EQ(tradeOffs(run).at(0).baseline, 2.0);
  EXPECT_EQ(tradeOffs(run).at(0).points.size(), 2u);
  for (Record& r : run.records)
    if (r.role == Role::Baseline) r.contamination = {"other programs"};
  EXPECT_EQ(tradeOffs(run).at(0).baseline, std::nullopt);
  EXPECT_TRUE(tradeOffs(run).at(0).equalTime.empty());
  EXPECT_EQ(tradeOffs(run).at(0).equalError.size(), 4u);
}

}  // namespace
}  // namespace report
