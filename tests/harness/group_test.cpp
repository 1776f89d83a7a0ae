// A group measured on the null backend, which draws nothing: what is called, recorded and refused.
#include <gtest/gtest.h>

#include "backends/rhi/memory_limit.h"
#include "tests/harness/named_backend.h"

namespace sb::test {
namespace {

class NullGroup : public testing::Test {
 protected:
  NullGroup() { shadowbench_shader_blob::addTo(m_shaders); }

  std::vector<CellResult> measure(const std::vector<CellId>& cells, const MeasureSettings& s) {
    Devices devices({&m_vulkan, &m_opengl, &m_broken}, m_shaders, {});
    return measureGroup({cells.begin(), cells.end()}, devices, s, "test");
  }

  rhi::ShaderLibrary m_shaders;
  NamedBackend m_vulkan{"vulkan"}, m_opengl{"opengl"}, m_broken{"opengl-osmesa", false};
};

TEST_F(NullGroup, FillsARecordOfEveryCell) {
  const auto results =
      measure({smallCell("none", "vulkan"), smallCell("ShadowMap", "vulkan"), smallCell("ShadowMap", "opengl")},
              shortSettings());
  ASSERT_EQ(results.size(), 3u);
  for (const CellResult& result : results) {
    const report::Record& r = result.record;
    ASSERT_EQ(r.status, report::Status::Ok) << r.name << ": " << r.reason;
    EXPECT_EQ(r.timeSource, "software");
    EXPECT_EQ(r.blocks.size(), 3u);
    EXPECT_EQ(r.stoppedBy, "repetitions");
    EXPECT_TRUE(r.stable.value_or(false));
    EXPECT_EQ(r.nonfinite, 0u);
    EXPECT_GT(r.drawCount, 0u);
    EXPECT_GT(r.bytes, 0u);
    EXPECT_EQ(r.sceneHash.size(), 16u);
    EXPECT_FALSE(r.knobs.empty() && r.id.technique != "none");
  }
  EXPECT_GT(results[1].record.passCount, results[0].record.passCount);
  EXPECT_EQ(results[1].record.crossBackendMax255, 0);
  EXPECT_EQ(results[1].record.sceneHash, results[0].record.sceneHash);
}

TEST_F(NullGroup, ErrorsThatWereNotAskedForAreAbsentWithTheReason) {
  const auto results = measure({smallCell("none", "vulkan")}, shortSettings());
  EXPECT_FALSE(results[0].record.visibility || results[0].record.image);
  EXPECT_EQ(results[0].record.why.at("image"), "no truth was asked for");
  EXPECT_TRUE(results[0].files.empty());
}

TEST_F(NullGroup, ADeviceThatDrawsNothingHasAnImageErrorAndNoVisibility) {
  MeasureSettings s = shortSettings();
  s.judge.enabled = true;
  const auto results = measure({smallCell("none", "vulkan")}, s);
  EXPECT_GT(results[0].record.image->all.rmse, 0.1);
  EXPECT_FALSE(results[0].record.visibility);
  EXPECT_EQ(results[0].record.why.at("visibility"), "no lit surface is in the picture");
}

TEST_F(NullGroup, BlocksOfACameraInMotionAreWholeLoops) {
  std::vector<CellId> cells = {smallCell("CSSM2", "vulkan"), smallCell("none", "opengl")};
  for (CellId& id : cells) id.scene = "layers?motion:move=0,0.5,0,steps=5";
  CellId standing = smallCell("CSSM2", "vulkan");
  MeasureSettings s = shortSettings();
  s.blockSeconds = 0.01;
  const auto results = measure(cells, s);
  const auto still = measure({standing}, shortSettings());
  for (const CellResult& result : results) {
    const report::Record& r = result.record;
    ASSERT_EQ(r.status, report::Status::Ok) << r.reason;
    EXPECT_TRUE(r.stable.value_or(false));
    for (const report::Block& block : r.blocks) EXPECT_EQ(block.frames % 5, 0u);
    EXPECT_NE(r.command.find("'layers?motion:move=0,0.5,0,steps=5'"), std::string::npos);
  }
  // The truth is that of the standing camera: kept under the same name.
  EXPECT_EQ(results[0].record.sceneHash, still[0].record.sceneHash);
  EXPECT_NE(results[0].record.name, still[0].record.name);
}

TEST_F(NullGroup, MapsThatDoNotFitAreSkippedWithBytesAndLimit) {
  rhi::pretendFreeMemory(uint64_t(1) << 30);
  CellId large = smallCell("CSSM2", "vulkan"), small = smallCell("CSSM2", "vulkan");
  large.knobs = {{"size", "16384"}};
  small.knobs = {{"size", "64"}};
  const auto results = measure({large, small}, shortSettings());
  rhi::pretendFreeMemory({});
  EXPECT_EQ(results[0].record.status, report::Status::Skipped);
  EXPECT_NE(results[0].record.reason.find(
                "'shadow map depth' (16384x16384, D32F) needs 1024 MiB beside the"),
            std::string::npos)
      << results[0].record.reason;
  EXPECT_NE(results[0].record.reason.find("expected at most 922 MiB of free memory"),
            std::string::npos)
      << results[0].record.reason;
  EXPECT_EQ(results[1].record.status, report::Status::Ok) << results[1].record.reason;
}

TEST_F(NullGroup, RayTracingIsARowWithItsTimeAndNoError) {
  MeasureSettings s = shortSettings();
  s.judge.enabled = true;
  const auto results =
      measure({smallCell("none", "vulkan"), smallCell("RayTraced", "cpu"), smallCell("ShadowMap", "vulkan")}, s);
  const report::Record& r = results[1].record;
  ASSERT_EQ(r.status, report::Status::Ok) << r.reason;
  EXPECT_GT(r.cpu->median, 0);
  EXPECT_EQ(r.visibility->all.rmse, 0);
  EXPECT_EQ(r.image->all.max, 0);
  EXPECT_EQ(r.image->flip, 0);
  EXPECT_GT(r.bytes, 1000u);
  EXPECT_TRUE(r.passes.empty());
  EXPECT_EQ(r.why.at("passes"), "ray tracing has no passes");
  if (r.contamination.empty() && results[0].record.contamination.empty()) {  // no debug build, no load
    ASSERT_EQ(r.ratios.size(), 1u);
    EXPECT_EQ(r.ratios[0].against, "none/vulkan/layers/16x16");
  }
}

TEST_F(NullGroup, ABackendThatDoesNotStartIsSkippedWithTheReason) {
  const auto results = measure({smallCell("none", "opengl-osmesa"), smallCell("none", "vulkan")}, shortSettings());
  EXPECT_EQ(results[0].record.status, report::Status::Skipped);
  EXPECT_NE(results[0].record.reason.find("no driver"), std::string::npos);
  EXPECT_EQ(results[1].record.status, report::Status::Ok);
}

TEST_F(NullGroup, InterruptionGivesTheGroupUp) {
  std::atomic<bool> interrupted = false;
  MeasureSettings s = shortSettings();
  s.interrupted = &interrupted;
  s.progress = [&](const std::string& what, double) { interrupted = what == "measure"; };
  EXPECT_TRUE(measure({smallCell("none", "vulkan"), smallCell("ShadowMap", "vulkan")}, s).empty());
  interrupted = true;
  EXPECT_TRUE(measure({smallCell("none", "vulkan")}, s).empty());
}

TEST_F(NullGroup, DevicesWithoutTrustedTimersGiveNoTimes) {
  MeasureSettings s = shortSettings();
  s.checkTimers = true;
  Devices devices({&m_vulkan, &m_opengl}, m_shaders, {});
  devices.open("vulkan")->timers = {{"twice the work", "ratio 1.0", false, TimerUse::Frame}};
  devices.open("opengl")->timers = {{"passes sum up", "0.1 of it", false, TimerUse::Passes}};
  const auto results =
      measureGroup({smallCell("none", "vulkan"), smallCell("none", "opengl")}, devices, s, "");
  EXPECT_EQ(results[0].record.status, report::Status::Failed);
  EXPECT_EQ(results[0].record.reason, "timer not trusted: twice the work: ratio 1.0");
  EXPECT_FALSE(results[0].record.frame);
  // The frame's time does not rest on the stamps of passes.
  EXPECT_EQ(results[1].record.status, report::Status::Ok);
  EXPECT_TRUE(results[1].record.frame);
  EXPECT_TRUE(results[1].record.passes.empty());
  EXPECT_EQ(results[1].record.why.at("passes"), "timer not trusted: passes sum up: 0.1 of it");
}

}  // namespace
}  // namespace sb::test
