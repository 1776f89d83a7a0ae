// What cells of a group say about each other.
#include "suites/harness/checks/compare.h"

#include <gtest/gtest.h>

namespace sb {
namespace {

class Compare : public testing::Test {
 protected:
  /// A cell on `backend` whose frames all take `cpuMs` and whose picture has one grey.
  void add(const std::string& technique, const std::string& backend, double cpuMs, float grey) {
    CellResult r;
    r.id = {.technique = technique, .backend = backend, .scene = "layers"};
    r.record.name = cellName(r.id);
    r.picture = {1, 1, {grey, grey, grey, 1}};
    FrameResult frame;
    frame.cpuMs = frame.wallMs = cpuMs;
    Samples s;
    s.blocks.assign(6, {{frame}});
    m_results.push_back(r);
    m_samples.push_back(s);
  }
  void compare() {
    std::vector<Measured> cells;
    for (size_t i = 0; i < m_results.size(); ++i)
      cells.push_back({&m_results[i], &m_samples[i], true});
    compareCells(cells);
  }
  report::Record& record(size_t i) { return m_results[i].record; }
  std::vector<CellResult> m_results;
  std::vector<Samples> m_samples;
};

TEST_F(Compare, RatiosAreAgainstTheBaselineAndTheOtherBackend) {
  add("none", "vulkan", 1, 0.5f);
  add("CSSM2", "vulkan", 3, 0.5f);
  add("CSSM2", "opengl", 6, 0.5f);
  compare();
  ASSERT_EQ(record(1).ratios.size(), 2u);
  EXPECT_EQ(record(1).ratios[0].kind, "baseline");
  EXPECT_EQ(record(1).ratios[0].against, "none/vulkan/layers/512x512");
  EXPECT_EQ(record(1).ratios[0].value, 3);
  EXPECT_EQ(record(1).ratios[1].kind, "backend");
  EXPECT_EQ(record(1).ratios[1].value, 0.5);
  EXPECT_TRUE(record(0).ratios.empty()) << "a baseline has none";
  EXPECT_TRUE(record(0).why.contains("ratios"));
  EXPECT_TRUE(record(0).why.contains("cross_backend_max_255"));
}

TEST_F(Compare, PicturesThatDifferAreCounted) {
  add("CSSM2", "vulkan", 1, 0.0f);
  add("CSSM2", "opengl", 1, 1.0f);
  compare();
  for (size_t i : {size_t(0), size_t(1)}) {
    EXPECT_EQ(*record(i).crossBackendMax255, 255);
    EXPECT_EQ(*record(i).crossBackendOver1, 1u);
  }
}

TEST_F(Compare, ContaminatedCellsAreInNoRatio) {
  add("none", "vulkan", 1, 0.5f);
  add("CSSM2", "vulkan", 3, 0.5f);
  record(0).contamination = {"validation is on"};
  compare();
  EXPECT_TRUE(record(1).ratios.empty());
  EXPECT_NE(record(1).why["ratios"].find("contaminated"), std::string::npos);
}

TEST_F(Compare, FailedCellsAreComparedWithNothing) {
  add("none", "vulkan", 1, 0.5f);
  add("CSSM2", "vulkan", 3, 0.5f);
  record(0).status = report::Status::Failed;
  compare();
  EXPECT_TRUE(record(1).ratios.empty());
}

}  // namespace
}  // namespace sb
