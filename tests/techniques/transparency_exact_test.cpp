// Transparency techniques that compose exactly (spec 15; B, C, E): the worked example, agreement
// with each other and with sorting, permutations, opaque and absent layers, energy, pass counts.
#include "suites/scenes/edit/transform.h"
#include "tests/techniques/transparency_scenes.h"

using namespace sb;
using namespace sb::test;

GPU_TEST(ExactTransparency, WorkedExample) {
  const Pane red{{1, 0, 0}, 0.5f}, green{{0, 1, 0}, 0.5f};
  for (const std::string& t : kExactTransparency) {
    SCOPED_TRACE(t);
    expectColor(rendered(device(), stack({red, green}, {0, 0, 1}), transparent(t)),
                {0.5f, 0.25f, 0.25f}, 0);
    expectColor(rendered(device(), stack({green, red}, {0, 0, 1}), transparent(t)),
                {0.25f, 0.5f, 0.25f}, 0);
  }
}

GPU_TEST(ExactTransparency, OddAndEvenNumbersOfLayers) {
  for (const std::string& t : kExactTransparency)
    for (uint32_t k = 1; k <= 8; ++k) {
      SCOPED_TRACE(t + " " + std::to_string(k));
      const auto list = panes(k, 0.375f);
      expectColor(rendered(device(), stack(list, {0.25f, 0.5f, 1}), transparent(t)),
                  composed(list, {0.25f, 0.5f, 1}), 0x1p-10f * float(k));
    }
}

GPU_TEST(ExactTransparency, AgreeOnATangleAndWithSortingWhereThatIsRight) {
  const rhi::Extent2D size{64, 48};
  for (const bool sortable : {false, true}) {
    const Scene scene = tangle(sortable);
    const auto peeled = rendered(device(), scene, transparent("DepthPeeling", {}, size));
    for (const std::string& t : kExactTransparency) {
      const auto other = rendered(device(), scene, transparent(t, {}, size));
      EXPECT_LE(largestDifference(peeled, other), 0x1p-10f * 10) << t << sortable;
    }
    const auto sorted =
        rendered(device(), scene, transparent("Sorted", {{"sort", "triangle"}}, size));
    if (sortable)
      EXPECT_LE(largestDifference(peeled, sorted), 0x1p-10f * 10);
    else
      EXPECT_GT(largestDifference(peeled, sorted), 0.05f) << "the panes do not cross";
  }
}

GPU_TEST(ExactTransparency, OrderOfTheSourcePlaysNoPart) {
  for (const std::string& t : kExactTransparency) {
    const auto before = rendered(device(), tangle(), transparent(t, {}, {64, 48}));
    for (const uint64_t seed : {1u, 2u, 3u}) {
      Scene permuted = tangle();
      permuteScene(permuted, seed);
      EXPECT_EQ(before, rendered(device(), permuted, transparent(t, {}, {64, 48}))) << t << seed;
    }
  }
}

GPU_TEST(ExactTransparency, LayersThatDoNotExistAndLayersThatHideAll) {
  for (const std::string& t : kExactTransparency) {
    SCOPED_TRACE(t);
    Scene opaque = tangle(), clear = tangle();
    opaque.instances.resize(2);
    for (size_t m = 1; m < clear.materials.size(); ++m) clear.materials[m].overrideAlpha = 0;
    Cell cell(cellDevice(device()), clear, transparent(t, {}, {64, 48}));
    EXPECT_EQ(cell.effects().visibleTranslucent.size(), 10u) << "there is nothing to leave out";
    EXPECT_EQ(rendered(device(), opaque, transparent(t, {}, {64, 48})), cell.picture().rgba);

    auto list = panes(5, 0.5f);
    list.front() = {{0.25f, 0.5f, 0.75f}, kAll};
    expectColor(rendered(device(), stack(list, {4, 4, 4}), transparent(t)), {0.25f, 0.5f, 0.75f},
                0x1p-11f);
  }
}

GPU_TEST(ExactTransparency, OneColourEverywhereStays) {
  const glm::vec3 color(0.3f, 0.6f, 0.9f);
  for (const std::string& t : kExactTransparency) {
    SCOPED_TRACE(t);
    std::vector<Pane> list;
    for (const float alpha : {0.1f, 0.9f, 0.33f, 0.5f, 0.77f}) list.push_back({color, alpha});
    expectColor(rendered(device(), stack(list, color), transparent(t)), color,
                0x1p-11f * 5);  // targets are half floats
  }
}

GPU_TEST(ExactTransparency, PassesFollowTheLayers) {
  for (uint32_t k = 1; k <= 5; ++k) {
    SCOPED_TRACE(k);
    const Scene scene = stack(panes(k, 0.25f), {0, 0, 1});
    Cell peeling(cellDevice(device()), scene, transparent("DepthPeeling", {{"layers", "8"}}));
    Cell dual(cellDevice(device()), scene, transparent("DualDepthPeeling", {{"layers", "8"}}));
    EXPECT_EQ(passesOf(peeling, "peel"), 8u) << "nothing is known of the first frame";
    EXPECT_EQ(passesOf(dual, "peel both sides"), 4u);
    const auto before = peeling.picture().rgba, both = dual.picture().rgba;
    for (int again = 0; again < 2; ++again) {
      peeling.renderAgain();
      dual.renderAgain();
      EXPECT_EQ(passesOf(peeling, "peel"), k + 1);
      EXPECT_EQ(passesOf(peeling, "composite"), 1u);
      EXPECT_EQ(passesOf(dual, "nearest and farthest") + passesOf(dual, "peel both sides"),
                (k + 1) / 2 + 1);
      EXPECT_EQ(before, peeling.picture().rgba);
      EXPECT_EQ(both, dual.picture().rgba);
    }
    Cell lists(cellDevice(device()), scene, transparent("LinkedLists"));
    EXPECT_EQ(lists.result().passes.size(), 3u);  // opaque, lists, sort and composite
  }
}
