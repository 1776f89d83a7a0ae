// Trees over what moves find what looking at each object finds, and less work does it.
#include "techniques/scene/tree/scene_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "suites/scenes/procedural/parts/random.h"
#include "techniques/scene/tree/box_hierarchy.h"
#include "techniques/scene/tree/quad_tree.h"

namespace sb {
namespace {

Box boxAround(const glm::dvec3& middle, double half) { return {middle - half, middle + half}; }

Box randomBox(Pcg& random, double room) {
  const glm::dvec3 middle(random.uniform(-room, room), random.uniform(0, 5),
                          random.uniform(-room, room));
  // Few are large.
  return boxAround(middle, random.below(20) == 0 ? random.uniform(1, room) : random.uniform(0, 1));
}

ConvexRegion randomRegion(Pcg& random) {
  ConvexRegion region;
  const glm::dvec3 middle(random.uniform(-60, 60), random.uniform(0, 5), random.uniform(-60, 60));
  if (random.below(2)) region.sphere = Sphere{middle, random.uniform(0, 20)};
  if (random.below(2) || !region.sphere) {
    Camera camera;
    camera.toWorld[3] = glm::dvec4(middle, 1);
    camera.orthographic = random.below(4) == 0;
    camera.halfHeight = 5;
    camera.farPlane = random.uniform(1, 80);
    region.origin = middle;
    region.halfSpaces = frustumHalfSpaces(camera, 1.5);
  }
  return region;
}

std::vector<uint32_t> found(const SceneTree& tree, const ConvexRegion& region) {
  std::vector<uint32_t> objects;
  tree.query(region, objects);
  std::ranges::sort(objects);
  return objects;
}

TEST(SceneTree, TreesFindWhatLookingAtEachFinds) {
  Pcg random(7);
  std::vector<Box> boxes;
  for (int i = 0; i < 300; ++i) boxes.push_back(randomBox(random, 50));
  boxes[5] = Box();  // nowhere yet
  for (const TreeKind kind : {TreeKind::QuadTree, TreeKind::Boxes}) {
    const auto tree = makeSceneTree(kind, boxes), reference = makeSceneTree(TreeKind::List, boxes);
    size_t most = 0;
    for (int round = 0; round < 400; ++round) {
      const uint32_t object = random.below(300);
      if (random.below(8) == 0) {
        tree->remove(object), reference->remove(object);
      } else {
        // Beyond where anything was at first, too.
        const Box box = randomBox(random, 90);
        tree->place(object, box), reference->place(object, box);
      }
      const ConvexRegion region = randomRegion(random);
      const std::vector<uint32_t> expected = found(*reference, region);
      most = std::max(most, expected.size());
      ASSERT_EQ(found(*tree, region), expected) << int(kind) << " round " << round;
    }
    EXPECT_GT(most, 30u);
  }
}

TEST(SceneTree, TreesAskForFewBoxes) {
  Pcg random(3);
  std::vector<Box> boxes;
  for (int i = 0; i < 4000; ++i)
    boxes.push_back(boxAround({random.uniform(-100, 100), 0, random.uniform(-100, 100)}, 0.5));
  const ConvexRegion small{.sphere = Sphere{{30, 0, 40}, 5}};
  std::vector<uint32_t> objects;
  EXPECT_EQ(makeSceneTree(TreeKind::List, boxes)->query(small, objects), 4000u);
  for (const TreeKind kind : {TreeKind::QuadTree, TreeKind::Boxes})
    EXPECT_LT(makeSceneTree(kind, boxes)->query(small, objects), 400u) << int(kind);
  // All that is in a square, or a box, that lies within is found without asking.
  const ConvexRegion all{.sphere = Sphere{{0, 0, 0}, 1000}};
  for (const TreeKind kind : {TreeKind::QuadTree, TreeKind::Boxes})
    EXPECT_LT(makeSceneTree(kind, boxes)->query(all, objects), 200u) << int(kind);
}

TEST(SceneTree, AnObjectLeavesItsSquareOnlyWhereItMust) {
  std::vector<Box> boxes;
  for (int i = 0; i < 64; ++i) boxes.push_back(boxAround({i % 8 + 0.5, 0, i / 8 + 0.5}, 0.2));
  QuadTree tree(boxes);
  ASSERT_EQ(tree.side(), 8u);
  EXPECT_EQ(tree.reinsertions(), 0u);
  tree.place(9, boxAround({1.6, 0, 1.6}, 0.2));  // within its square
  EXPECT_EQ(tree.reinsertions(), 0u);
  tree.place(9, boxAround({3.5, 0, 1.5}, 0.2));
  EXPECT_EQ(tree.reinsertions(), 1u);
  tree.place(9, boxAround({4, 0, 4}, 0.2));  // across the middle: the root's
  EXPECT_EQ(tree.reinsertions(), 2u);
  tree.place(9, boxAround({4, 0, 4.1}, 0.2));
  EXPECT_EQ(tree.reinsertions(), 2u);
  tree.place(9, boxAround({5.5, 0, 5.5}, 0.2));  // fits into a smaller one again
  EXPECT_EQ(tree.reinsertions(), 3u);
}

TEST(SceneTree, ABoxHierarchyIsMadeAnewWhenItHasGrown) {
  std::vector<Box> boxes;
  for (int i = 0; i < 64; ++i) boxes.push_back(boxAround({i % 8, 0, i / 8}, 0.2));
  BoxHierarchy tree(boxes);
  tree.place(3, boxAround({3.1, 0, 0}, 0.2));
  EXPECT_EQ(tree.builds(), 1u);
  for (uint32_t i = 0; i < 64; ++i)
    tree.place(i, boxAround({(i * 37) % 64 % 8, 0, (i * 37) % 64 / 8}, 0.2));
  EXPECT_GT(tree.builds(), 1u);
  EXPECT_LT(tree.builds(), 32u);
}

TEST(SceneTree, ARegionTellsInsideFromAcross) {
  const ConvexRegion region{.halfSpaces = {{{1, 0, 0}, 2}}, .sphere = Sphere{{0, 0, 0}, 4}};
  EXPECT_EQ(region.lies(boxAround({0, 0, 0}, 1)), Lies::Inside);
  EXPECT_EQ(region.lies(boxAround({-2, 0, 0}, 1)), Lies::Across);
  EXPECT_EQ(region.lies(boxAround({-3.5, 0, 0}, 1)), Lies::Outside);
  EXPECT_EQ(region.lies(boxAround({0, 3.5, 0}, 1)), Lies::Across);
  EXPECT_EQ(region.lies(boxAround({0, 5.5, 0}, 1)), Lies::Outside);
  // The corner of a box is nearer than the sphere's box.
  EXPECT_EQ(region.lies(boxAround({3.5, 3.5, 0}, 0.5)), Lies::Outside);
  EXPECT_EQ(region.lies(Box()), Lies::Outside);
}

}  // namespace
}  // namespace sb
