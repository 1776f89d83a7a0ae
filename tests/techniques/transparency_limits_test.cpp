// Limits of the exact techniques: more layers than they keep, pools that overflow, the far plane,
// coplanar surfaces.
#include <cmath>

#include "suites/scenes/edit/transform.h"
#include "tests/techniques/transparency_scenes.h"

using namespace sb;
using namespace sb::test;

namespace {

constexpr glm::vec3 kBackground(0.25f, 0.5f, 1);

/// Two quads in one plane before the background: twins of one mesh, of different colours.
Scene coplanar(bool redFirst) {
  Scene scene = stack({{{1, 0, 0}, 0.5f}, {{0, 1, 0}, 0.5f}}, {0, 0, 1});
  scene.instances[1].toWorld[3].z = 0.125;
  if (!redFirst) std::swap(scene.instances[0], scene.instances[1]);
  return scene;
}

}  // namespace

GPU_TEST(TransparencyLimits, LayersBeyondTheLastAreAnErrorOfWhatTheOthersLetThrough) {
  const float alpha = 0.5f;
  for (const uint32_t kept : {1u, 2u, 4u}) {
    // The deepest layer outshines all others, so that the bound is nearly met.
    auto list = panes(kept + 1, alpha);
    list.back() = {{1, 1, 1}, 0.984375f};
    const glm::vec3 exact = composed(list, {0, 0, 0});
    Cell cell(cellDevice(device()), stack(list, {0, 0, 0}),
              transparent("DepthPeeling", {{"stop", "count"}, {"layers", std::to_string(kept)}}));
    EXPECT_EQ(passesOf(cell, "peel"), kept);
    const auto picture = cell.picture().rgba;
    const float bound = std::pow(1 - alpha, float(kept));
    for (int c = 0; c < 3; ++c) {
      const float error = std::abs(picture[size_t(c)] - exact[c]);
      EXPECT_LE(error, bound + 0x1p-10f);
      EXPECT_GE(error, 0.9f * bound) << "the missing layer does not show";
    }
  }
}

GPU_TEST(TransparencyLimits, QueriesSayWhenLayersAreMissing) {
  for (const std::string t : {"DepthPeeling", "DualDepthPeeling"})
    for (const uint32_t layers : {3u, 4u, 6u}) {
      SCOPED_TRACE(t + std::to_string(layers));
      Cell cell(cellDevice(device()), stack(panes(layers, 0.25f), kBackground),
                transparent(t, {{"layers", "4"}}));
      for (int frame = 0; frame < 3; ++frame) {
        // A peeling that found something in its last pass cannot know that nothing is left.
        const size_t expected = t == "DepthPeeling" ? (layers >= 4) : (layers > 4);
        EXPECT_EQ(cell.renderer().warnings().size(), expected) << frame;
        cell.renderAgain();
      }
    }
}

GPU_TEST(TransparencyLimits, DualPeelingLosesTheMiddle) {
  auto list = panes(4, 0.5f);
  Cell cell(cellDevice(device()), stack(list, kBackground),
            transparent("DualDepthPeeling", {{"stop", "count"}, {"layers", "2"}}));
  list.erase(list.begin() + 1, list.begin() + 3);
  expectColor(cell.picture().rgba, composed(list, kBackground), 0x1p-9f);
}

GPU_TEST(TransparencyLimits, ALayerOnTheFarPlane) {
  // Orthographic from y = 0.5, far at 8: the deepest pane has depth 1 exactly.
  Scene scene;
  scene.background = {0, 0, 1};
  scene.cameras.push_back(downCamera({0, 0.5, 0}, 4, 8));
  const std::vector<Pane> list = {{{1, 0, 0}, 0.5f}, {{0, 1, 0}, 0.5f}};
  addHorizontal(scene, add(scene, shining({1, 0, 0}, 0.5f)), {0, 0, 0}, 8, 8);
  addHorizontal(scene, add(scene, shining({0, 1, 0}, 0.5f)), {0, -7.5f, 0}, 8, 8);
  const auto sorted = rendered(device(), scene, transparent("Sorted"));
  expectColor(sorted, {0.5f, 0.25f, 0.25f}, 0);
  for (const std::string& t : kExactTransparency)
    EXPECT_EQ(sorted, rendered(device(), scene, transparent(t))) << t;
  const auto stochastic = rendered(device(), scene, transparent("StochasticTransparency"));
  EXPECT_GT(stochastic[1], 0.1f) << "the layer on the far plane is missing";
}

GPU_TEST(TransparencyLimits, CoplanarSurfaces) {
  // Both are layers, as if a hair apart: red, whose mesh has the smaller key, before green.
  for (const bool redFirst : {true, false}) {
    const Scene scene = coplanar(redFirst);
    for (const char* t : {"Sorted", "DepthPeeling", "DualDepthPeeling", "LinkedLists"}) {
      SCOPED_TRACE(t);
      const auto picture = rendered(device(), scene, transparent(t));
      expectColor(picture, {0.5f, 0.25f, 0.25f}, 0);
      for (const uint64_t seed : {1u, 2u, 3u}) {
        Scene permuted = scene;
        permuteScene(permuted, seed);
        EXPECT_EQ(picture, rendered(device(), permuted, transparent(t)));
      }
    }
    expectColor(rendered(device(), scene, transparent("Sorted", {{"sort", "triangle"}})),
                {0.5f, 0.25f, 0.25f}, 0);
  }
}

GPU_TEST(TransparencyLimits, ListsAverageWhatTheyDoNotSort) {
  // One colour behind the sorted layers: the average is exact. Then many: deterministic at least,
  // and the transmittance of all is right.
  const glm::vec3 deep(0.75f, 0.25f, 0.5f);
  auto list = panes(8, 0.25f);
  for (int i = 0; i < 6; ++i) list.push_back({deep, i % 2 ? 0.5f : 0.125f});
  expectColor(rendered(device(), stack(list, kBackground),
                       transparent("LinkedLists", {{"layers", "8"}, {"pool", "16"}})),
              composed(list, kBackground), 0x1p-9f);
  Scene scene = tangle();
  for (int i = 0; i < 20; ++i)
    addQuad(scene, add(scene, shining({float(i % 3) / 2, float(i % 4) / 3, 0.5f}, 0.125f)),
            {0, 0, 1.25f + 0.0625f * float(i)}, {1, 0, 0}, {0, 1, 0});
  const CellOptions options =
      transparent("LinkedLists", {{"layers", "8"}, {"pool", "64"}}, {64, 48});
  Cell cell(cellDevice(device()), scene, options);
  EXPECT_TRUE(cell.renderer().warnings().empty());
  const auto before = cell.picture().rgba;
  for (const uint64_t seed : {1u, 2u, 3u}) {
    cell.renderAgain();
    EXPECT_EQ(before, cell.picture().rgba) << "frame to frame";
    Scene permuted = scene;
    permuteScene(permuted, seed);
    EXPECT_EQ(before, rendered(device(), permuted, options)) << seed;
  }
  // Sorting all of them changes the picture: the average was in use.
  EXPECT_GT(largestDifference(
                before,
                rendered(device(), scene,
                         transparent("LinkedLists", {{"layers", "64"}, {"pool", "64"}}, {64, 48}))),
            0.01f);
}

GPU_TEST(TransparencyLimits, ListsThatOverflowSaySo) {
  const auto list = panes(12, 0.25f);
  Cell cell(cellDevice(device()), stack(list, kBackground),
            transparent("LinkedLists", {{"pool", "4"}}));
  for (int frame = 0; frame < 2; ++frame) {
    const auto warnings = cell.renderer().warnings();
    ASSERT_EQ(warnings.size(), 1u);
    // 16 x 16 pixels: 12 layers asked for, 4 a pixel in the pool.
    EXPECT_NE(warnings[0].find("dropped 2048 of 3072 fragments"), std::string::npos) << warnings[0];
    const auto picture = cell.picture();
    for (const float v : picture.rgba) ASSERT_TRUE(v >= 0 && v <= 1.001f) << v;
    cell.renderAgain();
  }
  Cell enough(cellDevice(device()), stack(list, kBackground),
              transparent("LinkedLists", {{"pool", "12"}}));
  EXPECT_TRUE(enough.renderer().warnings().empty());
  expectColor(enough.picture().rgba, composed(list, kBackground), 0x1p-10f * 12);
}

GPU_TEST(TransparencyLimits, EightBitNodesAreNearlyThere) {
  const auto list = panes(4, 0.5f);
  const Scene scene = stack(list, kBackground);
  Cell small(cellDevice(device()), scene, transparent("LinkedLists", {{"nodes", "rgba8"}}));
  Cell large(cellDevice(device()), scene, transparent("LinkedLists"));
  expectColor(small.picture().rgba, composed(list, kBackground), 4.0f / 255);
  // Four panes over the whole picture, counted beforehand: four nodes a pixel.
  EXPECT_EQ(small.renderer().bytesByLabel().at("list nodes"), 16u * 16 * 4 * 16);
  EXPECT_EQ(large.renderer().bytesByLabel().at("list nodes"), 16u * 16 * 4 * 20);
}
