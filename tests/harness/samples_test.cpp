// From frames to a record.
#include "suites/harness/measuring/samples.h"

#include <gtest/gtest.h>

#include "reports/stats/stats.h"
#include "suites/harness/checks/plausible.h"
#include "suites/harness/checks/verify.h"

namespace sb {
namespace {

FrameResult plain(double wallMs, double cpuMs) {
  FrameResult f;
  f.recordMs = 0.1;
  f.submitMs = 0.2;
  f.wallMs = wallMs;
  f.cpuMs = cpuMs;
  f.counters.passes = 2;
  f.counters.draws = 3;
  return f;
}

FrameResult stamped(double shadowMs, double sceneMs, double wallMs) {
  FrameResult f = plain(wallMs, wallMs);
  f.stampedMs = shadowMs + sceneMs + 0.01;
  f.passes = {
      {.label = "map", .group = PassGroup::Shadow, .counters = {}, .ms = shadowMs, .fragments = {}},
      {.label = "camera",
       .group = PassGroup::Scene,
       .counters = {},
       .ms = sceneMs,
       .fragments = {}}};
  return f;
}

/// Plain frames that take as long as what the stamped ones say, and their wall time.
StampedLoop loopOf(std::vector<FrameResult> frames) {
  StampedLoop loop{frames, frames};
  for (FrameResult& f : loop.plain) {
    f.deviceMs = f.stampedMs;
    f.passes.clear();
  }
  return loop;
}

Samples samplesOf() {
  Samples s;
  s.compileMs = 12;
  s.blocks = {{{plain(1, 2), plain(3, 4)}}, {{plain(5, 6), plain(7, 8)}}};
  // Medians of the parts are 2 and 4, which no frame shows together.
  s.stamped = {loopOf({stamped(1, 4, 5.1)}), loopOf({stamped(2, 9, 11.1)}),
               loopOf({stamped(6, 2, 8.1)})};
  return s;
}

TEST(Samples, ALoopOfACameraInMotionIsOneSample) {
  Samples s = samplesOf();
  s.loop = 2;
  // Totals of the loops: 16, 8, 6; the middle one is (2, 1) and (3, 2).
  s.stamped = {loopOf({stamped(1, 4, 5.1), stamped(2, 9, 11.1)}),
               loopOf({stamped(2, 1, 3.1), stamped(3, 2, 5.1)}),
               loopOf({stamped(1, 1, 2.1), stamped(2, 2, 4.1)})};
  s.blocks[0].frames[0].counters.draws = 77;
  s.stamped[1].stamped[0].passes.push_back(
      {.label = "once", .group = PassGroup::Scene, .counters = {}, .ms = 0, .fragments = {}});
  report::Record r;
  summarise(s, true, r);
  EXPECT_EQ(r.shadowMs, 2.5);
  EXPECT_EQ(r.sceneMs, 1.5);
  ASSERT_EQ(r.passes.size(), 3u);
  EXPECT_EQ(r.passes[0].ms, 2.5);
  EXPECT_EQ(r.passes[0].count, 1u);
  EXPECT_EQ(r.passes[2].count, 0u) << "the last frame has no such pass";
  EXPECT_EQ(r.drawCount, 3u) << "counts are of the last frame";
}

TEST(Samples, SoftwareFramesAreWallTimeRankedByCpuTime) {
  report::Record r;
  summarise(samplesOf(), true, r);
  EXPECT_EQ(r.timeSource, "software");
  EXPECT_EQ(r.frame->median, 4);
  EXPECT_EQ(r.cpu->median, 5);
  EXPECT_EQ(r.frame->n, 4u);
  EXPECT_FALSE(r.device_);
  EXPECT_TRUE(r.why.contains("device_ms"));
  ASSERT_EQ(r.blocks.size(), 2u);
  EXPECT_EQ(r.blocks[1].frameMs, 6);
  EXPECT_EQ(r.blocks[1].cpuMs, 7);
  EXPECT_EQ(blockMeans(samplesOf(), true), (std::vector<double>{3, 7}));
  EXPECT_EQ(r.drawCount, 3u);
  EXPECT_EQ(*r.compileMs, 12);
}

TEST(Samples, PassesAddUpToNoMoreThanTheStampedFrame) {
  report::Record r;
  summarise(samplesOf(), true, r);
  ASSERT_TRUE(r.combinedMs);
  EXPECT_EQ(*r.combinedMs, *r.shadowMs + *r.sceneMs);
  EXPECT_LE(*r.combinedMs, *r.stampedFrameMs);
  ASSERT_EQ(r.passes.size(), 2u);
  EXPECT_EQ(r.passes[0].ms + r.passes[1].ms, *r.combinedMs);
  EXPECT_LE(r.passes[0].share + r.passes[1].share, 1);
  EXPECT_EQ(*r.shadowMs, 6) << "of the frame in the middle";
}

TEST(Samples, RoundingDoesNotPushPassesBeyondTheFrame) {
  Samples s = samplesOf();
  s.stamped = {loopOf({stamped(0.1, 0.2, 0.31)})};
  s.stamped[0].stamped[0].stampedMs = 0.3;  // 0.1 + 0.2 is more than that
  report::Record r;
  summarise(s, true, r);
  EXPECT_LE(*r.combinedMs, *r.stampedFrameMs);
}

TEST(Samples, GraphicsDevicesAreTimedByTheirStampsAlone) {
  Samples s = samplesOf();
  for (SampleBlock& b : s.blocks)
    for (FrameResult& f : b.frames) f.deviceMs = f.wallMs / 2;
  report::Record r;
  summarise(s, false, r);
  EXPECT_EQ(r.timeSource, "gpu-timestamp");
  EXPECT_EQ(r.frame->median, 2);
  report::Record noStamps;
  summarise(samplesOf(), false, noStamps);
  EXPECT_EQ(noStamps.timeSource, "wall") << "without stamps it is no time of the device";
}

TEST(Samples, BrokenStampsOfSoftwareCostTheDevicesTimeAlone) {
  Samples s = samplesOf();
  for (SampleBlock& b : s.blocks)
    for (FrameResult& f : b.frames) f.stampsBroken = "its timestamps span 9 ms";
  report::Record r;
  summarise(s, true, r);
  EXPECT_FALSE(r.device_);
  EXPECT_NE(r.why["device_ms"].find("not trusted"), std::string::npos);
  EXPECT_TRUE(r.frame);
}

TEST(Samples, LoopsWithBrokenStampsAreDroppedWholeAndCounted) {
  Samples s;
  s.loop = 2;
  std::vector<FrameResult> frames = {plain(1, 1), plain(2, 2), plain(3, 3), plain(4, 4)};
  frames[1].stampsBroken = "its timestamps span an hour";
  EXPECT_TRUE(addBlock(s, frames, false));
  ASSERT_EQ(s.blocks.size(), 1u);
  ASSERT_EQ(s.blocks[0].frames.size(), 2u);
  EXPECT_EQ(s.blocks[0].frames[0].wallMs, 3);
  EXPECT_EQ(s.dropped, 2u);
  frames[3].stampsBroken = frames[1].stampsBroken;
  EXPECT_FALSE(addBlock(s, frames, false)) << "nothing is left";
  EXPECT_EQ(s.blocks.size(), 1u);
  EXPECT_TRUE(addBlock(s, frames, true)) << "software is timed without stamps";
  report::Record r;
  summarise(s, false, r);
  EXPECT_EQ(r.droppedFrames, 6u);
  EXPECT_EQ(r.warnings.size(), 1u);
}

TEST(Samples, TheMedianIsOfBlocksPercentilesAreOfFrames) {
  Samples s = samplesOf();
  s.blocks.push_back({{plain(100, 1), plain(300, 1)}});
  report::Record r;
  summarise(s, true, r);
  EXPECT_EQ(r.frame->median, 6) << "the middle of 2, 6 and 200";
  EXPECT_EQ(r.frame->median, report::median(std::vector<double>{2, 6, 200}));
  EXPECT_EQ(r.frame->n, 6u);
  EXPECT_NEAR(r.frame->p99, 290, 1e-9);
  EXPECT_NEAR(r.frame->p95, 250, 1e-9);
}

TEST(Samples, PassesThatMissWorkAreRefused) {
  Samples s = samplesOf();
  for (StampedLoop& loop : s.stamped) loop.stamped[0].wallMs *= 3;
  report::Record r;
  summarise(s, true, r);
  EXPECT_TRUE(r.passes.empty());
  EXPECT_FALSE(r.shadowMs || r.sceneMs || r.combinedMs || r.stampedFrameMs);
  EXPECT_NE(r.why["shadow_ms"].find("not trusted"), std::string::npos);
  EXPECT_TRUE(r.frame) << "the frame's own time does not rest on the stamps";
}

TEST(Samples, PassesOfAGpuAreHeldAgainstTheFrameWithoutStamps) {
  Samples s = samplesOf();
  report::Record good;
  summarise(s, false, good);
  EXPECT_FALSE(good.passes.empty());
  // The stamps agree with one another, and see a third of what the frame takes.
  for (StampedLoop& loop : s.stamped) loop.plain[0].deviceMs = 3 * *loop.plain[0].stampedMs;
  report::Record r;
  summarise(s, false, r);
  EXPECT_TRUE(r.passes.empty());
  EXPECT_NE(r.why["passes"].find("frame without stamps"), std::string::npos) << r.why["passes"];
}

TEST(Samples, OneDisturbedFrameDoesNotDamnTheTimer) {
  Samples s = samplesOf();
  s.stamped[0].stamped[0].wallMs *= 3;
  s.stamped[1].stamped[0].wallMs *= 3;
  report::Record r;
  summarise(s, true, r);
  EXPECT_FALSE(r.passes.empty());
}

TEST(Plausible, TimesThatNoDeviceCanHaveAreRefused) {
  EXPECT_EQ(whyImplausible(samplesOf(), true), "");
  Samples s = samplesOf();
  s.blocks[0].frames[0].wallMs = 0;
  EXPECT_NE(whyImplausible(s, true).find("no time"), std::string::npos);
  s = samplesOf();
  s.blocks[0].frames[0].deviceMs = 1e12;
  EXPECT_NE(whyImplausible(s, false).find("all of them"), std::string::npos);
  s = samplesOf();
  s.blocks.back().frames.back().counters.triangles = 2'000'000;
  s.blocks[0].frames[0].deviceMs = 1e-3;
  EXPECT_NE(whyImplausible(s, false).find("triangles"), std::string::npos) << "2e12 a second";
  s.blocks[0].frames[0].deviceMs = 1e-2;
  EXPECT_EQ(whyImplausible(s, false), "") << "2e11 a second";
}

TEST(Samples, TheDevicesVerdictOnItsStampsCounts) {
  Samples s = samplesOf();
  s.passesUntrusted = "timer not trusted: so said the check";
  report::Record r;
  summarise(s, false, r);
  EXPECT_EQ(r.why["passes"], s.passesUntrusted);
}

TEST(Verify, RefusesWhatCannotBeBelieved) {
  report::Record good;
  good.stable = true;
  good.nonfinite = 0;
  good.drawCount = 1;
  EXPECT_EQ(whyRefused(good), "");
  auto with = [&](auto change) {
    report::Record r = good;
    change(r);
    return whyRefused(r);
  };
  EXPECT_NE(with([](auto& r) { r.stable = false; }), "");
  EXPECT_NE(with([](auto& r) { r.stable = {}; }), "");
  EXPECT_NE(with([](auto& r) { r.nonfinite = 2; }), "");
  EXPECT_NE(with([](auto& r) { r.nonfinite = {}; }), "");
  EXPECT_NE(with([](auto& r) { r.drawCount = 0; }), "");
}

TEST(Verify, CountsWhatDiffers) {
  report::Picture a{2, 1, {0, 0, 0, 1, 1, 0.5f, 0, 1}}, b = a;
  EXPECT_EQ(maxDifference255(a, b), 0);
  EXPECT_FALSE(isUniform(a));
  b.rgba[4] = 0;
  EXPECT_EQ(maxDifference255(a, b), 255);
  EXPECT_EQ(pixelsBeyondOneStep(a, b), 1u);
  b.rgba[5] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(countNonFinite(b), 1u);
  EXPECT_NE(contentHashOf(a), contentHashOf(b));
  EXPECT_EQ(maxDifference255(a, {1, 1, {0, 0, 0, 1}}), 255);
  EXPECT_TRUE(isUniform({2, 1, {0, 0, 0, 1, 0, 0, 0, 1}}));
}

}  // namespace
}  // namespace sb
