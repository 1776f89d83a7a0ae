// Errors of real cells against the traced truth: what must be small is, what a technique cannot show
// is found and blamed, unbiased techniques are certified and a biased one is not.
#include "suites/harness/checks/certify.h"
#include "suites/harness/judge.h"
#include "suites/metrics/error.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "tests/techniques/gpu_cell.h"

using namespace sb;
using namespace sb::test;

namespace {

/// A renderer of the tests as a subject of the judge.
class CellSubject final : public Subject {
 public:
  explicit CellSubject(Cell& cell) : m_cell(cell) {}
  FrameResult frame(FrameMode mode) override { return m_cell.renderer().frame(mode); }
  report::Picture picture() override { return m_cell.picture(); }
  bool software() const override { return true; }
  double createMs() const override { return 0; }
  std::vector<uint32_t> lights() const override { return m_cell.renderer().lights(); }
  std::vector<VisibilityImage> visibility(uint32_t light, uint32_t seed) override {
    return m_cell.renderer().visibilityAtEnd(light, seed);
  }
  LookupReach reach(uint32_t light) const override { return m_cell.renderer().reach(light); }
  std::string whyNotRandom() const override { return m_cell.renderer().whyNotRandom(); }
  void describe(report::Record&) const override {}

 private:
  Cell& m_cell;
};

report::Record judged(CellDevice& device, const Scene& scene, const CellOptions& options,
                      uint32_t seeds = 16) {
  Cell cell(device, scene, options);
  CellSubject subject(cell);
  report::Record record;
  PictureFiles files;
  Judge judge(cell.scene(), "test", options.size, {.seeds = seeds, .cache = {}});
  judge.judge(subject,
              {.technique = options.technique, .transparency = "Sorted", .backend = "test",
               .scene = "test", .width = options.size.width, .height = options.size.height},
              cell.picture(), record, files);
  for (const auto& [role, hash] : record.pictures) EXPECT_TRUE(files.contains(hash)) << role;
  return record;
}

double shareOf(const report::Record& record, const std::string& cause) {
  for (const auto& [name, share] : record.blame->shares)
    if (name == cause) return share;
  return -1;
}

CellOptions small(const std::string& technique, std::map<std::string, std::string> knobs = {}) {
  return {.technique = technique, .knobs = std::move(knobs), .size = {64, 64}};
}

}  // namespace

GPU_TEST(JudgeCells, AnOpaqueShadowErrsAtItsEdgeAlone) {
  Scene scene = floorScene();
  addHorizontal(scene, 0, {0.055f, 1, 0.03f}, 1, 1);
  const report::Record r = judged(cellDevice(device()), scene,
                                  small("ShadowMap", {{"compare", "manual"}, {"size", "64"}}));
  ASSERT_TRUE(r.visibility);
  EXPECT_GT(r.visibility->all.rmse, 0);
  EXPECT_EQ(r.visibility->interior.max, 0);
  EXPECT_LT(r.image->interior.max, 2.0 / 255);
  EXPECT_NEAR(shareOf(r, "resolution"), 1, 1e-9);
  EXPECT_EQ(r.visibilityLayers.size(), 2u);  // the first opaque surface is the first surface
  EXPECT_EQ(r.why.at("noise"), "nothing random runs");
  EXPECT_EQ(r.truthStderr, 0.0);
}

GPU_TEST(JudgeCells, WhatAMapCannotShowOfAnAreaLightIsItsError) {
  Scene scene = floorScene();
  addHorizontal(scene, 0, {0, 2, 0}, 1, 1);
  const CellOptions options = small("ShadowMap", {{"size", "512"}, {"kernel", "1"}});
  const report::Record hard = judged(cellDevice(device()), scene, options);
  scene.lights[0].angularRadius = 0.2;  // penumbrae of 6 pixels to either side
  const report::Record soft = judged(cellDevice(device()), scene, options);
  ASSERT_TRUE(hard.visibility && soft.visibility);
  EXPECT_LT(hard.visibility->interior.max, 1e-3);
  EXPECT_GT(soft.visibility->interior.max, 0.3) << "penumbrae are no edges";
  EXPECT_GT(soft.visibility->all.rmse, 5 * hard.visibility->all.rmse);
  EXPECT_GT(*soft.truthStderr, 0);
  EXPECT_LT(*soft.truthStderr, 5e-4);
  // Not to be blamed on the lookup: what its texels hold is right.
  EXPECT_LT(shareOf(soft, "resolution"), 0.5);
  Cell cell(cellDevice(device()), scene, options);
  const auto lacking = cell.renderer().plan().unrepresented;
  EXPECT_EQ(std::ranges::count(lacking, Effect::AreaLights), 1);
}

GPU_TEST(JudgeCells, MissingShadowsAreLeaks) {
  Scene scene = floorScene();
  addHorizontal(scene, 0, {0.055f, 1, 0.03f}, 1, 1);
  const report::Record r = judged(cellDevice(device()), scene, small("none"));
  EXPECT_EQ(shareOf(r, "leaking"), 1);
  EXPECT_EQ(r.visibility->all.max, 1);
  EXPECT_GT(r.visibility->all.bias, 0);
}

GPU_TEST(JudgeCells, AMediumThatNoTechniqueShowsIsItsError) {
  // Mist of depth 1 above the right half of the floor, out of view: light is said to pass.
  Scene scene = floorScene();
  scene.media.push_back({.name = "mist", .extinction = glm::vec3(0.5f), .albedo = glm::vec3(1)});
  scene.media[0].boxToWorld = glm::dmat4(4, 0, 0, 0, 0, 2, 0, 0, 0, 0, 8, 0, 0, 1, -4, 1);
  const report::Record r = judged(cellDevice(device()), scene, small("ShadowMap"));
  ASSERT_TRUE(r.visibility && r.image);
  const double taken = 1 - std::exp(-1.0);
  EXPECT_NEAR(r.visibility->all.rmse, taken * std::sqrt(0.5), 1e-3);
  EXPECT_NEAR(r.visibility->all.bias, taken / 2, 1e-3);
  // Two of 32 columns lie so near its edge that a lookup might have found it.
  EXPECT_NEAR(shareOf(r, "leaking"), 30.0 / 32, 1e-9);
  // In view it is missing from the picture as well.
  scene.media[0].boxToWorld[3].y = -1;
  scene.media[0].boxToWorld[1].y = 1.25;
  EXPECT_GT(judged(cellDevice(device()), scene, small("ShadowMap")).image->all.rmse, 0.01);
}

GPU_TEST(JudgeCells, WhatALightGrazesHardlyCountsByLight) {
  // A cube whose front the light grazes lies in the shadow of a lid, a slanted board in the light:
  // without shadows the front alone is wrong.
  Scene scene;
  add(scene, matte());
  addLight(scene, sun({0, -1, -0.001}));
  addBox(scene, 0, {-2, 0, -2}, {2, 2, 2});
  addHorizontal(scene, 0, {0, 2.5f, 2.5f}, 2.2f, 0.6f);
  addQuad(scene, 0, {4.5f, 1, 1}, {2, 0, 0}, {0, 1, -1});
  scene.cameras.push_back(lookAt({1, 1, 16}, {1, 1, 0}, 0.6, 60));
  const report::Record r = judged(cellDevice(device()), scene, small("none"));
  ASSERT_TRUE(r.visibility && r.visibility->weighted);
  EXPECT_GT(r.visibility->all.rmse, 0.5);
  EXPECT_LT(*r.visibility->weighted, 0.1);
}

GPU_TEST(JudgeCells, TheStochasticMapIsUnbiasedAndItsNoiseFallsWithTheKernel) {
  const Material pane = glass(0.8f, {0.9f, 0.3f, 0.3f});
  Scene scene = floorScene();
  addHorizontal(scene, add(scene, pane), {0, 2, 0}, 5, 5);
  double noise[2];
  for (const int i : {0, 1}) {
    const report::Record r = judged(
        cellDevice(device()), scene,
        small("CSSM2", {{"kernel", i == 0 ? "3" : "9"}, {"size", "512"}}));
    ASSERT_TRUE(r.noise && r.certificate);
    EXPECT_EQ(r.noise->seeds, 16u);
    EXPECT_EQ(r.certificate->unbiased, true) << r.certificate->why;
    ASSERT_GE(r.certificate->regions.size(), 3u);
    EXPECT_GT(r.certificate->regions[0].trials, 1000u);
    // What the mean of 16 seeds still strays is no bias.
    EXPECT_LT(r.noise->biasRmse / r.noise->noise, 0.05);
    EXPECT_LE(r.noise->biasLow, 0);
    EXPECT_GE(r.noise->biasHigh, 0);
    EXPECT_GT(shareOf(r, "noise"), 0.95);
    noise[i] = r.noise->noise;
  }
  EXPECT_NEAR(noise[0] / noise[1], 3, 0.4);
}

// Lookups that are no sums of equal independent draws are judged by their means over seeds.
GPU_TEST(JudgeCells, EveryKindOfLookupGetsAVerdict) {
  Scene scene = floorScene();
  addHorizontal(scene, add(scene, glass(0.8f, {0.9f, 1, 1})), {0, 2, 0}, 5, 5);
  const struct {
    const char *technique, *knob, *value;
    bool unbiased;
    uint32_t seeds = 24;
  } kKinds[] = {
      {"CSSM2", "noise", "texture", true},
      {"CSSM2", "noise", "stratified", true},
      {"CSSM2", "noise", "blue", true},
      {"CSSM2", "shape", "tent", true},
      {"CSSM1", "compare", "hardware", true},
      // Where nine texels agree by chance they are believed.
      {"CSSM2", "filter", "adaptive", false},
      // 8 bits, and a number equal to p blocks: one level of 256 too many (-0.0020 at q = 0.92).
      {"CSSM2", "noise", "source", false, 64},
  };
  for (const auto& kind : kKinds) {
    SCOPED_TRACE(std::string(kind.technique) + "/" + kind.knob + ":" + kind.value);
    const report::Record r =
        judged(cellDevice(device()), scene,
               small(kind.technique, {{"kernel", "9"}, {"size", "256"}, {kind.knob, kind.value}}),
               kind.seeds);
    ASSERT_TRUE(r.certificate);
    EXPECT_EQ(r.certificate->test, "mean");
    EXPECT_EQ(r.certificate->unbiased, kind.unbiased) << r.certificate->why;
    EXPECT_GT(r.certificate->informative, 0u);
  }
}

GPU_TEST(JudgeCells, ABiasedStochasticMapIsNotCertified) {
  // The truth of a slightly other pane: as if the technique drew with the wrong probability.
  Scene scene = floorScene();
  addHorizontal(scene, add(scene, glass(0.8f, {0.9f, 0.3f, 0.3f})), {0, 2, 0}, 5, 5);
  CellOptions options = small("CSSM2", {{"kernel", "3"}, {"size", "512"}});
  Cell cell(cellDevice(device()), scene, options);
  Scene other = scene;
  other.materials.back().overrideAlpha = 0.7f;
  const Tracer tracer(other, 64, 64);
  const auto truth = tracer.trace({.width = 64, .height = 64});
  const LookupReach reach = cell.renderer().reach(0);
  auto regions = trialRegions(tracer, truth->visibility[0], truth->edges[0], {64, 64}, 0, 0, reach);
  ASSERT_FALSE(regions.empty());
  for (uint32_t seed = 0; seed < 16; ++seed) {
    cell.renderer().setSeed(seed);
    cell.renderer().frame();
    const auto layers = cell.renderer().readVisibility(0);
    for (TrialRegion& r : regions) addSeed(r, layers[0], reach.trials);
  }
  EXPECT_EQ(certificateOf(regions, {64, 64}).unbiased, false);
}
