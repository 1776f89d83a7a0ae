// Every hard case of every technique at its small size: nothing fails that is not an error by
// construction, and what must be found is found.
#include "suites/stability/stability.h"

#include "techniques/plan/error.h"
#include "tests/techniques/gpu_cell.h"

using namespace sb;

namespace {

/// One that ended early has no points.
std::string told(const report::StabilityRecord& r) {
  std::string out = r.name() + ": " + r.why;
  if (const report::StabilityPoint* p = r.worst())
    out += "; found " + std::to_string(p->value) + " at " + std::to_string(p->x) + ", allowed " +
           std::to_string(p->tolerance);
  return out;
}

std::vector<report::StabilityRecord> runAll(test::CellDevice& device, const std::string& backend,
                                            const std::string& filter) {
  std::vector<report::StabilityRecord> records;
  const DeviceContext context = device.context();
  for (const StabilityJob& job : stabilityJobs({.backends = {backend}, .filter = filter, .quick = true}))
    records.push_back(runStability(job, context, nullptr));
  return records;
}

}  // namespace

GPU_TEST(Stability, NothingFails) {
  const auto records = runAll(test::cellDevice(device()), backend(), "");
  EXPECT_GT(records.size(), 100u);
  size_t passed = 0;
  for (const report::StabilityRecord& r : records) {
    passed += r.verdict == report::Verdict::Pass;
    EXPECT_NE(r.verdict, report::Verdict::Fail)
        << told(r);
  }
  EXPECT_GT(passed, records.size() / 2);
}

GPU_TEST(Stability, WhatATechniqueCannotShowIsFound) {
  for (const auto& [filter, verdict] : {std::pair{"^layers/ShadowMap/", report::Verdict::Expected},
                                        {"^between/TranslucentShadows/", report::Verdict::Expected},
                                        {"^between/CompositedTranslucent/", report::Verdict::Pass},
                                        {"^camera crossing/none/", report::Verdict::Expected},
                                        {"^G6/CSSM2/", report::Verdict::Skipped}}) {
    const auto records = runAll(test::cellDevice(device()), backend(), filter);
    ASSERT_EQ(records.size(), 1u) << filter;
    EXPECT_EQ(records[0].verdict, verdict) << filter << " " << records[0].why;
  }
}

GPU_TEST(Stability, PeeledCastersBeforeTheViewKeepTheirDepths) {
  // The camera sees the floor alone: what is clamped to the near plane would peel as one layer.
  const DeviceContext context = test::cellDevice(device()).context();
  const StabilityJob job{.caseId = "layers",
                         .technique = "CompositedTranslucent",
                         .transparency = "Sorted",
                         .backend = backend(),
                         .knobs = {{"partition", "peeled"}},
                         .quick = true};
  const report::StabilityRecord record = runStability(job, context, nullptr);
  EXPECT_EQ(record.verdict, report::Verdict::Pass) << told(record);
}

TEST(StabilityJobs, AreNamedAndSelected) {
  const auto all = stabilityJobs({.backends = {"vulkan"}});
  size_t moved = 0;
  for (const StabilityJob& job : all) {
    if (job.caseId.starts_with("camera")) EXPECT_EQ(job.technique, "none") << jobName(job);
    if (job.caseId == "layers") EXPECT_NE(job.technique, "none") << jobName(job);
    moved += job.caseId == "G1" && job.technique == "none";
  }
  EXPECT_GE(moved, 5u);  // what holds for any picture is asked of transparency too
  const auto some = stabilityJobs({.techniques = {"CSSM2"},
                                   .cases = {"G1", "H7"},
                                   .backends = {"vulkan", "opengl"},
                                   .filter = "H7"});
  ASSERT_EQ(some.size(), 2u);
  EXPECT_EQ(jobName(some[1]), "H7/CSSM2/opengl");
  EXPECT_THROW(stabilityJobs({.techniques = {"CSM2"}}), InputError);
  EXPECT_THROW(stabilityJobs({.cases = {"G99"}}), InputError);
  EXPECT_THROW(stabilityJobs({.filter = "("}), InputError);
  EXPECT_THROW(stabilityJobs({.variants = {{{"kernal", "3"}}}}), InputError);
}

TEST(StabilityJobs, VariantsAreAskedOfThoseThatHaveTheKnob) {
  const auto jobs = stabilityJobs({.techniques = {"CSSM2", "ShadowMap"},
                                   .cases = {"G1"},
                                   .backends = {"vulkan"},
                                   .variants = {{{"format", "rgba16"}}, {{"kernel", "3"}}},
                                   .seeds = 64});
  ASSERT_EQ(jobs.size(), 3u);
  EXPECT_EQ(jobName(jobs[0]), "G1/CSSM2/format:rgba16/vulkan");
  EXPECT_EQ(jobName(jobs[2]), "G1/ShadowMap/kernel:3/vulkan");
  EXPECT_EQ(jobs[0].seeds, 64u);
}

TEST(StabilityJobs, AskTheGenericPropertiesOfAScene) {
  const auto jobs = stabilityJobs({.techniques = {"CSSM2"},
                                   .backends = {"vulkan"},
                                   .scenes = {"layers", "a/b.glb"},
                                   .size = rhi::Extent2D{32, 24}});
  ASSERT_EQ(jobs.size(), 24u);  // G1 to G11, and G3 of lights
  EXPECT_EQ(jobName(jobs[0]), "G1/CSSM2/vulkan/layers/32x24");
  EXPECT_EQ(jobName(jobs[1]), "G1/CSSM2/vulkan/a/b.glb/32x24");
  const auto named = stabilityJobs({.cases = {"layers", "G8"}, .backends = {"opengl"},
                                    .scenes = {"layers"}});
  for (const StabilityJob& job : named) EXPECT_EQ(job.caseId, "G8");
  EXPECT_EQ(named.empty(), false);
}

GPU_TEST(Stability, TheGenericPropertiesHoldOnScenes) {
  const DeviceContext context = test::cellDevice(device()).context();
  for (const std::string scene : {"layers", "panes"}) {
    size_t passed = 0;
    for (const StabilityJob& job : stabilityJobs({.techniques = {"ShadowMap", "CSSM2"},
                                                  .backends = {backend()},
                                                  .scenes = {scene},
                                                  .size = rhi::Extent2D{64, 48},
                                                  .quick = true})) {
      const report::StabilityRecord r = runStability(job, context, &context);
      passed += r.verdict == report::Verdict::Pass;
      EXPECT_NE(r.verdict, report::Verdict::Fail) << told(r);
    }
    EXPECT_GE(passed, 18u) << scene;
  }
}
