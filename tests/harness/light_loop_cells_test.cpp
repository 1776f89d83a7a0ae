// The third question in cells: T[+X][@L] from the command line to the record, with loops that only
// tests know.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "reports/json/json_cell.h"
#include "suites/stability/stability.h"
#include "techniques/plan/error.h"
#include "techniques/render/registry.h"
#include "tests/harness/named_backend.h"

namespace sb::test {
namespace {

constexpr const char* kTestLoop = "TestLoop";    ///< has the knob "reach"
constexpr const char* kNeedyLoop = "NeedyLoop";  ///< needs what no device here has

// Both under the shader of AllLights: the question is how cells name them.
class TestLoop final : public LightTechnique {};
class NeedyLoop final : public LightTechnique {};

REGISTER_TECHNIQUE(LightTechnique, TestLoop,
                   (TechniqueInfo{.name = kTestLoop,
                                  .folder = "all_lights",
                                  .title = "for tests",
                                  .paper = "none",
                                  .represents = {Effect::ParticipatingMedia},
                                  .knobs = {{.name = "reach",
                                             .unit = "lights",
                                             .help = "for tests",
                                             .fallback = "4",
                                             .min = 1,
                                             .max = 64}},
                                  .error = "it leaves out no light"}));
REGISTER_TECHNIQUE(LightTechnique, NeedyLoop,
                   (TechniqueInfo{.name = kNeedyLoop,
                                  .folder = "all_lights",
                                  .title = "for tests",
                                  .paper = "none",
                                  .requires_ = {rhi::Feature::Presentation},
                                  .error = "it leaves out no light"}));

std::vector<CellId> selected(const Selection& s) {
  return selectCells(s, kBackendNames, kDefaultBackends);
}

std::vector<std::string> namesOf(const std::vector<CellId>& cells) {
  std::vector<std::string> names;
  for (const CellId& id : cells) names.push_back(cellName(id));
  return names;
}

using Names = std::vector<std::string>;

TEST(LightLoopCells, NamesSayTheLoopUnlessItIsTheDefault) {
  const auto cells = selected(
      {.techniques = {"CSSM2@AllLights", "CSSM2@TestLoop", "CSSM2+DepthPeeling@TestLoop", "CSSM2"},
       .backends = {"vulkan"},
       .scenes = {"layers"}});
  EXPECT_EQ(namesOf(cells),
            (Names{"CSSM2/vulkan/layers/512x512", "CSSM2@TestLoop/vulkan/layers/512x512",
                   "CSSM2+DepthPeeling@TestLoop/vulkan/layers/512x512"}));
  EXPECT_EQ(cells[0].lights, kDefaultLights);
  EXPECT_EQ(cells[2].lights, kTestLoop);
  EXPECT_EQ(cells[2].transparency, "DepthPeeling");
  EXPECT_EQ(cellCommand(cells[2]),
            "./bench --technique CSSM2+DepthPeeling@TestLoop --backend vulkan --scene layers "
            "--size 512x512");
}

TEST(LightLoopCells, WithoutANameTheLoopIsTheDefault) {
  for (const CellId& id : selected({})) EXPECT_EQ(id.lights, kDefaultLights) << cellName(id);
}

TEST(LightLoopCells, NamesFindThemselvesAsFilters) {
  const Selection all{.techniques = {"none@TestLoop", "none", "CSSM2@TestLoop"},
                      .scenes = {"layers"}};
  Selection one = all;
  for (const std::string& name : namesOf(selected(all))) {
    one.filter = name;
    EXPECT_EQ(namesOf(selected(one)), Names{name});
  }
  one.filter = "@TestLoop";
  EXPECT_EQ(selected(one).size(), 4u);
}

TEST(LightLoopCells, WhatIsNoCombinationIsRefusedWithTheNearest) {
  const auto complaint = [](const std::string& technique) -> std::string {
    try {
      selected({.techniques = {technique}});
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_NE(complaint("CSSM2@TestLop").find("did you mean TestLoop"), std::string::npos);
  const std::string form = "expected TECHNIQUE[+TRANSPARENCY][@LIGHTS]";
  for (const char* text : {"CSSM2@TestLoop+Sorted", "CSSM2@TestLoop@AllLights", "CSSM2+Sorted+x"})
    EXPECT_NE(complaint(text).find(form), std::string::npos) << complaint(text);
  for (const char* text : {"CSSM2@", "@TestLoop", "CSSM2+@TestLoop"})
    EXPECT_NE(complaint(text).find("unknown"), std::string::npos) << complaint(text);
  EXPECT_NE(complaint("RayTraced@TestLoop").find("expected RayTraced alone"), std::string::npos);
}

TEST(LightLoopCells, TheLoopHasKnobsOfItsOwn) {
  const auto cells = selected({.techniques = {"none", "none@TestLoop", "ShadowMap@TestLoop"},
                               .backends = {"vulkan"},
                               .scenes = {"layers"},
                               .sets = {"reach=4,8.0", "size=512"}});
  EXPECT_EQ(namesOf(cells),
            (Names{"none/vulkan/layers/512x512", "none@TestLoop/vulkan/layers/512x512",
                   "none@TestLoop/vulkan/layers/reach:8/512x512",
                   "ShadowMap@TestLoop/vulkan/layers/size:512/512x512",
                   "ShadowMap@TestLoop/vulkan/layers/size:512/reach:8/512x512"}));
  try {
    selected({.techniques = {"none"}, .sets = {"reach=8"}});
    FAIL() << "a knob that nothing has";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("which is a knob of TestLoop"), std::string::npos);
  }
}

TEST(LightLoopCells, CostsAreToldAgainstTheSameLoop) {
  const CellId id = withKnobs({.technique = "ShadowMap", .lights = kTestLoop, .backend = "vulkan"},
                              {{"reach", "8"}, {"size", "512"}});
  const CellId baseline = baselineOf(id);
  EXPECT_EQ(techniqueName(baseline), "none@TestLoop");
  EXPECT_EQ(baseline.knobs, (decltype(baseline.knobs){{"reach", "8"}}));
  EXPECT_EQ(roleOf(baseline), report::Role::Baseline);
  EXPECT_EQ(baselineOf(baseline), baseline);
}

TEST(LightLoopCells, AllThreeAreAskedWhatTheyRepresentAndNeed) {
  const CellId id{.technique = "ShadowMap", .lights = kTestLoop};
  EXPECT_TRUE(representedBy(techniquesOf(id)).has(Effect::ParticipatingMedia));
  EXPECT_FALSE(
      representedBy(techniquesOf({.technique = "ShadowMap"})).has(Effect::ParticipatingMedia));
  const auto device = null_backend::makeBackend()->open({});
  const auto why = [&](const CellId& cell, EffectSet present = {}) {
    const auto skip = unsupported(*device, techniquesOf(cell), cellKnobs(cell), present);
    return skip ? skip->reason : "";
  };
  EXPECT_EQ(why(id), "");
  EXPECT_EQ(why({.technique = "ShadowMap", .lights = kNeedyLoop}), "the device lacks presentation");
  TechniqueInfo sometimes{.name = "Sometimes"};
  sometimes.requiresFor[Effect::LocalLights] = rhi::Feature::Presentation;
  TechniqueSet set = techniquesOf(id);
  set.lights = &sometimes;
  EXPECT_FALSE(unsupported(*device, set, {}, {}));
  EXPECT_EQ(unsupported(*device, set, {}, {Effect::LocalLights})->reason,
            "the device lacks presentation, which Sometimes needs for local-lights");
}

TEST(LightLoopCells, RecordsCarryTheLoopItsKnobsAndItsRefusals) {
  rhi::ShaderLibrary shaders;
  shadowbench_shader_blob::addTo(shaders);
  NamedBackend vulkan{"vulkan"}, opengl{"opengl"};
  Devices devices({&vulkan, &opengl}, shaders, {});
  CellId looped = smallCell("ShadowMap", "vulkan"), needy = looped;
  looped.lights = kTestLoop;
  looped.knobs = {{"reach", "8"}};
  needy.lights = kNeedyLoop;
  std::vector<GroupCell> cells = {smallCell("ShadowMap", "opengl"), looped, needy,
                                  smallCell("none", "vulkan")};
  addBaselines(cells);
  const auto results = measureGroup(cells, devices, shortSettings(), "test");
  ASSERT_EQ(results.size(), 7u);
  for (size_t i = 0; i < 7; ++i) EXPECT_EQ(results[i].companion, i > 3);
  const CellResult& baseline = results[5];
  EXPECT_EQ(baseline.record.name, "none@TestLoop/vulkan/layers/reach:8/16x16");
  EXPECT_EQ(baseline.record.role, report::Role::Baseline);
  const report::Record& r = results[1].record;
  ASSERT_EQ(r.status, report::Status::Ok) << r.reason;
  EXPECT_EQ(r.name, "ShadowMap@TestLoop/vulkan/layers/reach:8/16x16");
  EXPECT_EQ(r.id, looped);
  EXPECT_EQ(r.knobs.at("reach"), "8");
  EXPECT_EQ(r.role, report::Role::Technique);
  if (r.contamination.empty() && baseline.record.contamination.empty()) {
    ASSERT_EQ(r.ratios.size(), 1u);
    EXPECT_EQ(r.ratios[0].against, baseline.record.name);
  }
  EXPECT_FALSE(r.crossBackendMax255) << "the other API's cell has another loop";
  EXPECT_EQ(results[2].record.status, report::Status::Skipped);
  EXPECT_EQ(results[2].record.reason, "the device lacks presentation");
  const report::Json json = report::cellToJson(r);
  EXPECT_EQ(json.back().at("lights"), kTestLoop);
  EXPECT_EQ(json.back().at("knobs_changed"), report::Json({"reach"}));
  const std::string file = "a.json";
  EXPECT_EQ(report::readCell(report::Field(json, file)).id, looped);
}

TEST(LightLoopCells, HardCasesAskALoopWithoutShadows) {
  std::set<std::string> names;
  for (const StabilityJob& job : stabilityJobs({.cases = {"G1", "layers"}, .backends = {"vulkan"}}))
    names.insert(jobName(job));
  EXPECT_TRUE(names.contains("G1/none@TestLoop/vulkan"));
  EXPECT_FALSE(names.contains("G1/CSSM2@TestLoop/vulkan"));
  const auto jobs = stabilityJobs({.techniques = {"CSSM2@TestLoop"},
                                   .cases = {"G1"},
                                   .backends = {"vulkan"},
                                   .variants = {{{"reach", "8"}}}});
  ASSERT_EQ(jobs.size(), 1u);
  EXPECT_EQ(jobs[0].lights, kTestLoop);
  EXPECT_EQ(jobName(jobs[0]), "G1/CSSM2@TestLoop/reach:8/vulkan");
}

TEST(Roles, OneTechniqueIsTheBaselineAndTheTracerIsNone) {
  size_t baselines = 0;
  for (const ShadowEntry* t : shadowTechniques()) {
    baselines += t->info.baseline;
    EXPECT_FALSE(t->info.tracer) << t->info.name;
    EXPECT_EQ(roleOf({.technique = t->info.name}),
              t == &baselineTechnique() ? report::Role::Baseline : report::Role::Technique);
  }
  EXPECT_EQ(baselines, 1u);
  EXPECT_EQ(baselineTechnique().info.name, "none");
  EXPECT_EQ(shadowTechniques().front(), &baselineTechnique());
  EXPECT_EQ(roleOf({.technique = "RayTraced"}), report::Role::Tracer);
  EXPECT_TRUE(referenceInfo().tracer);
}

}  // namespace
}  // namespace sb::test
