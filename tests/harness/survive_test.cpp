// Groups that end early, go on, do not fit, lose their device, or are too slow: on the null
// backend, with faults where a driver would have them.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "backends/rhi/memory_limit.h"
#include "tests/harness/named_backend.h"

namespace sb::test {
namespace {

class Survive : public testing::Test {
 protected:
  Survive() {
    shadowbench_shader_blob::addTo(m_shaders);
    m_settings.interrupted = &m_interrupted;
    m_settings.onBlock = [&](const CellId& cell, const SampleBlock& block) {
      m_blocks[cell].push_back(block);
    };
    m_settings.onVerified = [&](const CellResult& r) { m_verified.push_back(r.record); };
  }
  ~Survive() override { rhi::pretendFreeMemory({}); }

  std::vector<CellResult> measure(const std::vector<CellId>& cells) {
    return measureGroup({cells.begin(), cells.end()}, m_devices, m_settings, "test");
  }
  size_t blocks() const {
    size_t count = 0;
    for (const auto& [cell, list] : m_blocks) count += list.size();
    return count;
  }

  std::atomic<bool> m_interrupted = false;
  rhi::ShaderLibrary m_shaders;
  NamedBackend m_vulkan{"vulkan"}, m_opengl{"opengl"};
  Devices m_devices{{&m_vulkan, &m_opengl}, m_shaders, {}};
  MeasureSettings m_settings = shortSettings();
  std::map<CellId, std::vector<SampleBlock>> m_blocks;
  std::vector<report::Record> m_verified;
};

TEST_F(Survive, AnInterruptLosesNoBlockThatWasMeasured) {
  const std::vector<CellId> cells = {smallCell("none", "vulkan"), smallCell("ShadowMap", "vulkan"),
                                     smallCell("CSSM2", "vulkan")};
  const auto put = m_settings.onBlock;
  for (const size_t at : {1u, 4u, 5u, 8u, 9u}) {
    SCOPED_TRACE(at);
    m_blocks.clear();
    m_interrupted = false;
    m_settings.earlierBlocks = nullptr;
    m_settings.onBlock = [&](const CellId& cell, const SampleBlock& block) {
      put(cell, block);
      m_interrupted = blocks() == at;
    };
    for (const CellResult& r : measure(cells)) EXPECT_TRUE(r.finished);
    EXPECT_EQ(blocks(), at);
    // Going on measures the rest, and each cell has what it would have had.
    const auto earlier = m_blocks;
    m_interrupted = false;
    m_settings.onBlock = put;
    m_settings.earlierBlocks = &earlier;
    const auto results = measure(cells);
    ASSERT_EQ(results.size(), 3u);
    EXPECT_EQ(blocks(), 9u);
    for (const CellResult& r : results) {
      EXPECT_EQ(r.record.status, report::Status::Ok) << r.record.reason;
      EXPECT_EQ(r.record.blocks.size(), 3u);
    }
    for (const report::Ratio& r : results[1].record.ratios) EXPECT_EQ(r.n, 3u);
  }
}

TEST_F(Survive, CellsThatWereVerifiedAreKeptWhenTheirGroupIsCut) {
  m_settings.onVerified = [&](const CellResult& r) {
    m_verified.push_back(r.record);
    m_interrupted = m_verified.size() == 2;
  };
  const auto results = measure(
      {smallCell("none", "vulkan"), smallCell("ShadowMap", "vulkan"), smallCell("CSSM2", "vulkan")});
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[1].record.name, "ShadowMap/vulkan/layers/16x16");
  // Both sides of it are finished.
  if (results[1].record.contamination.empty()) EXPECT_EQ(results[1].record.ratios.size(), 1u);
  ASSERT_EQ(m_verified.size(), 2u);
  EXPECT_TRUE(m_verified[1].ratios.empty());
  EXPECT_EQ(m_verified[1].why.at("ratios"),
            "the run ended before this cell was compared with the others of its group");
}

TEST_F(Survive, CompanionsAreNotTold) {
  measureGroup({smallCell("ShadowMap", "vulkan"), {smallCell("none", "vulkan"), true}}, m_devices,
               m_settings, "test");
  ASSERT_EQ(m_verified.size(), 1u);
  EXPECT_EQ(m_verified[0].id.technique, "ShadowMap");
}

TEST_F(Survive, ADeviceThatIsLostFailsItsCellsAndTheOtherGoesOn) {
  int passes = 0;
  for (const int at : {1, 2, 7, 20, 31}) {
    SCOPED_TRACE(at);
    Devices devices({&m_vulkan, &m_opengl}, m_shaders, {});
    passes = 0;
    m_vulkan.faults.onPass = [&] {
      if (++passes >= at) throw rhi::Error("vkQueueSubmit2", "VK_ERROR_DEVICE_LOST", "gone");
    };
    const auto results = measureGroup({smallCell("none", "vulkan"), smallCell("none", "opengl"),
                                       smallCell("ShadowMap", "vulkan"), smallCell("ShadowMap", "opengl")},
                                      devices, m_settings, "test");
    m_vulkan.faults.onPass = [] {};
    ASSERT_EQ(results.size(), 4u);
    size_t lost = 0;
    for (const CellResult& r : results) {
      if (r.id.backend == "opengl") {
        EXPECT_EQ(r.record.status, report::Status::Ok) << r.record.reason;
        continue;
      }
      lost += r.record.status == report::Status::Failed;
      if (r.record.status == report::Status::Failed)
        EXPECT_NE(r.record.reason.find("VK_ERROR_DEVICE_LOST"), std::string::npos);
      EXPECT_FALSE(r.record.status == report::Status::Failed && r.record.frame);
    }
    EXPECT_GT(lost, 0u);
    EXPECT_FALSE(devices.whyLost("vulkan").empty());
    EXPECT_TRUE(devices.whyLost("opengl").empty());
  }
}

// At every pass that a group draws: the cell fails, and the device serves the others.
TEST_F(Survive, AnExceptionWhileRecordingLeavesNoHalfFrame) {
  int passes = 0, at = 0;
  m_vulkan.faults.onPass = [&] {
    if (++passes == at) throw rhi::Error("vkCmdDraw", "VK_ERROR_UNKNOWN", "for this test");
  };
  const std::vector<CellId> cells = {smallCell("none", "vulkan"), smallCell("CSSM2", "vulkan")};
  measure(cells);
  const int all = passes;
  EXPECT_GT(all, 20);
  for (at = 1; at <= all; at += 3) {
    passes = 0;
    const auto results = measure(cells);
    ASSERT_EQ(results.size(), 2u);
    EXPECT_EQ(std::ranges::count(results, report::Status::Failed,
                                 [](const CellResult& r) { return r.record.status; }),
              1)
        << at;
  }
}

TEST_F(Survive, MapsThatDoNotFitTogetherAreMeasuredApart) {
  std::vector<CellId> cells = {smallCell("none", "vulkan")};
  for (const char* technique : {"ShadowMap", "CSSM2", "TranslucentShadows"}) {
    cells.push_back(smallCell(technique, "vulkan"));
    cells.back().knobs = {{"size", "4096"}};
  }
  const auto alone = measure(cells);
  uint64_t most = 0, sum = 0;
  for (const CellResult& r : alone) {
    ASSERT_EQ(r.record.status, report::Status::Ok) << r.record.reason;
    for (const std::string& w : r.record.warnings) EXPECT_EQ(w.find("fit the memory"), w.npos);
    most = std::max(most, r.record.bytes);
    sum += r.record.bytes;
  }
  ASSERT_GT(sum, most * 5 / 4);
  rhi::limitHostMemory(most * 9 / 8 + (8u << 20));
  const auto results = measure(cells);
  rhi::limitHostMemory(UINT64_MAX);
  ASSERT_EQ(results.size(), 4u);
  size_t apart = 0;
  for (size_t i = 0; i < results.size(); ++i) {
    const report::Record& r = results[i].record;
    EXPECT_EQ(r.name, alone[i].record.name);
    EXPECT_EQ(r.status, report::Status::Ok) << r.name << ": " << r.reason;
    if (i > 0 && !r.why.contains("ratios")) EXPECT_EQ(r.ratios.size(), 1u) << r.name;
    apart += std::ranges::count_if(r.warnings, [](const std::string& w) {
      return w.find("together they do not fit the memory") != w.npos;
    });
  }
  EXPECT_GE(apart, 1u);
}

TEST_F(Survive, WhatDoesNotFitAloneIsSkippedOnce) {
  CellId large = smallCell("CSSM2", "vulkan"), other = smallCell("CSSM2", "opengl");
  for (CellId* id : {&large, &other}) id->knobs = {{"size", "8192"}};
  rhi::limitHostMemory(64u << 20);
  const auto results = measure({smallCell("none", "vulkan"), large, other});
  rhi::limitHostMemory(UINT64_MAX);
  ASSERT_EQ(results.size(), 3u);
  for (const CellResult& r : results) {
    const bool fits = r.id.technique == "none";
    EXPECT_EQ(r.record.status, fits ? report::Status::Ok : report::Status::Skipped);
    if (!fits) EXPECT_TRUE(r.record.reason.starts_with(rhi::kTooLargeWords)) << r.record.reason;
  }
}

TEST_F(Survive, MemoryThatRunsOutIsASkipWithWords) {
  m_vulkan.faults.onTexture = [] { throw std::bad_alloc(); };
  const auto results = measure({smallCell("ShadowMap", "vulkan"), smallCell("ShadowMap", "opengl")});
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].record.status, report::Status::Skipped);
  EXPECT_TRUE(results[0].record.reason.starts_with(rhi::kTooLargeWords));
  EXPECT_EQ(results[1].record.status, report::Status::Ok) << results[1].record.reason;
}

// A frame of 60 ms at a budget of 20 ms; the other cell gets its blocks all the same.
TEST_F(Survive, SlowCellsKeepToTheirBudget) {
  m_settings.stop = {.precision = 1e-9, .minBlocks = 6, .repetitions = 0};
  m_settings.budgetSeconds = 0.02;
  m_opengl.faults.onPass = [] { std::this_thread::sleep_for(std::chrono::milliseconds(30)); };
  const auto results = measure({smallCell("none", "vulkan"), smallCell("none", "opengl")});
  m_opengl.faults.onPass = [] {};
  ASSERT_EQ(results.size(), 2u);
  const report::Record &quick = results[0].record, &slow = results[1].record;
  ASSERT_EQ(slow.status, report::Status::Ok) << slow.reason;
  EXPECT_EQ(slow.blocks.size(), 1u);
  EXPECT_EQ(slow.stoppedBy, "budget");
  EXPECT_FALSE(slow.precision);
  EXPECT_NE(slow.why.at("precision").find("1 blocks"), std::string::npos);
  EXPECT_TRUE(slow.ratios.empty());
  if (slow.contamination.empty() && quick.contamination.empty())
    EXPECT_NE(slow.why.at("ratios").find("fewer than 6 pairs"), std::string::npos);
  EXPECT_GE(quick.blocks.size(), 6u);
  EXPECT_TRUE(quick.precision);
}

}  // namespace
}  // namespace sb::test
