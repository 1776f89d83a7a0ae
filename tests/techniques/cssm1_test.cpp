// CSSM1 (spec 04): its layers are CSSM2's channels bit by bit, whatever sends casters there; means,
// order, hardware comparison. And CSSM2's adaptive filter.
#include "suites/scenes/edit/transform.h"
#include "suites/scenes/procedural/procedural.h"
#include "tests/techniques/cssm2_helpers.h"

using namespace sb;
using namespace sb::test;

namespace {

CellOptions cssm1(std::map<std::string, std::string> knobs = {}) {
  CellOptions options = mapsOnly(std::move(knobs));
  options.technique = "CSSM1";
  return options;
}

/// Panes, boxes, and lights of every type.
Scene everyLight() {
  Scene scene = stack({workedA(), workedB()});
  addBox(scene, 0, {-1, 0.25f, -1}, {1, 1.5f, 1});
  addQuad(scene, add(scene, glass(0.6f, {0.2f, 0.9f, 0.5f})), {2, 1, 1}, {0.5f, 0.5f, 0},
          {0, 0.25f, 0.75f});
  scene.lights[0] = sun({0.25, -1, 0.5});
  addLight(scene, pointLight({1.5, 2.5, -1}, 4));
  addLight(scene, spotLight({-2, 3, 1}, {0.5, -1, -0.25}, 0.75, 6));
  return scene;
}

uint32_t layersOf(const Cell& cell) {
  uint32_t layers = 0;
  for (const LightView& view : cell.lightViews()) layers += view.layer >= 0;
  return layers;
}

void expectSameMaps(Cell& one, Cell& two, const std::string& what) {
  ASSERT_GT(layersOf(two), 0u) << what;
  for (uint32_t layer = 0; layer < layersOf(two); ++layer) {
    const auto colours = two.map("colours", layer);
    for (uint32_t c = 0; c < 3; ++c) {
      const auto depth = one.map("depth", 3 * layer + c);
      size_t different = 0;
      for (size_t i = 0; i < depth.size(); ++i) different += depth[i] != colours[4 * i + c];
      EXPECT_EQ(different, 0u) << what << " layer " << layer << " channel " << c;
    }
  }
}

}  // namespace

GPU_TEST(Cssm1, LayersAreCssm2sChannels) {
  for (const char* numbers : {"independent", "shared"})
    for (const char* layered : {"vertex", "geometry"}) {
      Cell one(cellDevice(device()), everyLight(),
               cssm1({{"numbers", numbers}, {"layered", layered}, {"size", "128"}}));
      Cell two(cellDevice(device()), everyLight(),
               mapsOnly({{"numbers", numbers}, {"size", "128"}}));
      expectSameMaps(one, two, std::string(numbers) + " " + layered);
      EXPECT_EQ(one.picture().rgba, two.picture().rgba);
    }
}

GPU_TEST(Cssm1, TexturedPanesToo) {
  Cell one(cellDevice(device()), makeScene("window"), cssm1());
  Cell two(cellDevice(device()), makeScene("window"), mapsOnly());
  expectSameMaps(one, two, "window");
}

GPU_TEST(Cssm1, OtherKindsOfNumbersToo) {
  for (const char* noise : {"texture", "stratified", "blue"}) {
    Cell one(cellDevice(device()), stack({workedA(), workedB()}), cssm1({{"noise", noise}}));
    Cell two(cellDevice(device()), stack({workedA(), workedB()}), mapsOnly({{"noise", noise}}));
    expectSameMaps(one, two, noise);
  }
}

GPU_TEST(Cssm1, WorkedExampleAtEveryReceiverByBothComparisons) {
  for (const char* compare : {"manual", "hardware"}) {
    CellOptions options = single({{"compare", compare}});
    options.technique = "CSSM1";
    Cell cell(cellDevice(device()), stack({workedA(), workedB()}), options);
    const auto& layers = cell.visibility();
    for (const auto& [layer, q] : {std::pair{0, glm::dvec3(0.552, 0.396, 0.264)},
                                   {1, glm::dvec3(1)},
                                   {2, glm::dvec3(0.92, 0.44, 0.44)}}) {
      const Moments m = momentsOf(layers[size_t(layer)], cell.size());
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(m.mean[c], q[c], fourSigma(q[c], double(m.count))) << compare << layer << c;
    }
  }
}

GPU_TEST(Cssm1, PermutationIsBitIdentical) {
  const Scene scene = everyLight();
  Cell before(cellDevice(device()), scene, cssm1());
  Scene permuted = scene;
  permuteScene(permuted, 1);
  permuted.lights = scene.lights;
  Cell after(cellDevice(device()), permuted, cssm1());
  for (uint32_t layer = 0; layer < 3 * layersOf(before); ++layer)
    EXPECT_EQ(before.map("depth", layer), after.map("depth", layer)) << layer;
}

GPU_TEST(Cssm1, WhatLetsEverythingPassLeavesTheMapsAlone) {
  const auto mapsWith = [&](std::optional<Material> pane) {
    Scene scene = stack({workedA(), workedB()});
    if (pane) addHorizontal(scene, add(scene, *pane), {0, 1.5f, 0}, 3, 3);
    Cell cell(cellDevice(device()), scene, cssm1());
    return std::array{cell.map("depth", 0), cell.map("depth", 1), cell.map("depth", 2)};
  };
  const auto without = mapsWith({});
  EXPECT_EQ(without, mapsWith(glass(0, {0.3f, 0.6f, 0.9f})));
  EXPECT_EQ(without, mapsWith(glass(1, glm::vec3(1))));
  EXPECT_NE(without, mapsWith(glass(0.01f, glm::vec3(0))));
  // What passes one channel alone leaves that channel alone.
  const auto red = mapsWith(glass(1, {1, 0, 0}));
  EXPECT_EQ(without[0], red[0]);
  EXPECT_NE(without[1], red[1]);
}

GPU_TEST(AdaptiveFilter, IsTheFullOneAtEdgesAndItsBiasIsTheFormula) {
  // Numbers shared and grey: all channels draw alike. 3 x 3 texels that agree are believed.
  for (const double q : {0.95, 0.9, 0.6, 0.5, 0.2}) {
    const Material pane = glass(float(1 - q), glm::vec3(0));
    Cell cell(
        cellDevice(device()), stack({pane}),
        single({{"numbers", "shared"}, {"kernel", "5"}, {"filter", "adaptive"}, {"size", "1024"}}));
    const Moments m = momentsOf(cell.visibility()[0], cell.size());
    const double bias = (1 - 9.0 / 25) * (std::pow(q, 9) * (1 - q) - std::pow(1 - q, 9) * q);
    // Pixels of 4 x 4 texels share some of 25 with their neighbours: a ninth of them are
    // independent.
    EXPECT_NEAR(m.mean.x, q + bias, 4 * std::sqrt(q * (1 - q) / 25 * 9 / double(m.count))) << q;
  }
  // Opaque alone away from edges: nine texels decide as twenty-five do.
  Scene scene = stack({workedA()});
  addHorizontal(scene, 0, {0, 1.5f, 0}, 1, 1);
  scene.cameras = floorScene().cameras;  // sees the floor from below both
  const auto visibility = [&](const char* filter) {
    Cell cell(cellDevice(device()), scene, single({{"kernel", "5"}, {"filter", filter}}));
    EXPECT_EQ(cell.renderer().reach(0).trials, std::string(filter) == "full" ? 25u : 0u);
    return cell.visibility()[0];
  };
  const auto full = visibility("full"), adaptive = visibility("adaptive");
  const size_t centre = 4 * (128 * 256 + 128);
  EXPECT_EQ(full[centre], 0);
  EXPECT_EQ(adaptive[centre], 0);
}
