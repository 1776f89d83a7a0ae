// What light views may hold where a camera is set freely.
#include "techniques/draw/fit/view_fit.h"

#include <gtest/gtest.h>

#include "suites/scenes/analysis/free_views.h"
#include "suites/scenes/procedural/parts/shapes.h"

namespace sb::test {
namespace {

TEST(ViewFit, WhereverACameraStandsAViewHasRoomForEveryCasterOfItsLight) {
  // A lamp between two boxes: each face looks at one of them at most.
  Scene scene = floorScene(false);
  const uint32_t grey = add(scene, matte());
  const uint32_t left = addBox(scene, grey, {-3, 0.5f, -0.25f}, {-2.5f, 1, 0.25f});
  const uint32_t right = addBox(scene, grey, {2.5f, 0.5f, -0.25f}, {3, 1, 0.25f});
  addLight(scene, pointLight({0, 0.75, 0}));
  const FreeViews views(scene, 1, 64);
  const Effects& anywhere = views.anywhere();
  const ViewFit::Step step{PlacedScene(scene).seenBy(*anywhere.overview), anywhere};
  ViewFit standing(1, false), free(1, true);
  for (ViewFit* fit : {&standing, &free}) fit->prepare({.mapSize = 64}, {&step, 1});
  const auto holdsBoth = [&](const LightView& view) {
    return std::ranges::count(view.opaque, left) + std::ranges::count(view.opaque, right) == 2;
  };
  EXPECT_GE(free.views().size(), 4u) << "faces";
  EXPECT_FALSE(std::ranges::any_of(standing.views(), holdsBoth));
  EXPECT_TRUE(std::ranges::all_of(free.views(), holdsBoth));
  free.fit(step);
  EXPECT_FALSE(std::ranges::any_of(free.views(), holdsBoth)) << "drawn are those of the face";
}

}  // namespace
}  // namespace sb::test
