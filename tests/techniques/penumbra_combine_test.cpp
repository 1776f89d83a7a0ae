// The sources' ways to combine volumes and wedges (spec 08, PER_LOOP and SPLIT_HALVES): the share
// of the light for what they can show, and where they err by construction.
#include "tests/techniques/penumbra_scenes.h"

using namespace sb;
using namespace sb::test;

namespace {

CellOptions combine(const char* how, std::map<std::string, std::string> knobs = {}) {
  knobs["combine"] = how;
  return {.technique = "PenumbraWedge", .knobs = std::move(knobs), .size = {48, 36}};
}

/// Two convex sheets that nowhere overlap before the light.
PenumbraScene convexSheets(const glm::dvec3& eye = {2, 5, 6}) {
  PenumbraScene s = penumbraFloor(ball(0.5), eye);
  addSheet(s, {-0.75, 1, -0.5}, {0.5, 0.25, 0.125}, {0.125, 0.25, 0.5}, {1, 1, 1, 1, 1});
  addSheet(s, {1.25, 0.75, 0.5}, {0.5, 0.25, 0}, {0, 0, 0.5}, {1, 1, 1});
  return s;
}

PenumbraScene star() {
  PenumbraScene s = penumbraFloor(ball(0.5));
  addSheet(s, {0.25, 1.25, 0}, {1, 0.25, 0}, {0, 0.25, 0.875},
           {1, 0.25, 0.875, 0.25, 1.125, 0.375, 0.75, 0.25, 1, 0.25});
  return s;
}

}  // namespace

GPU_TEST(PenumbraCombine, ConvexLoopsOneByOneAreExact) {
  // From outside, and from within the penumbra.
  for (const glm::dvec3 eye : {glm::dvec3(2, 5, 6), glm::dvec3(-0.9, 0.25, -0.5)}) {
    const PenumbraScene s = convexSheets(eye);
    Cell cell(cellDevice(device()), s.scene, combine("loop"));
    expectPenumbra(cell, s, "loop", 20);
  }
  // A mesh of two pieces has two loops.
  PenumbraScene s = convexSheets();
  Mesh& first = s.scene.meshes[s.scene.meshes.size() - 2];
  const Mesh second = s.scene.meshes.back();
  for (const uint32_t i : second.indices)
    first.indices.push_back(i + uint32_t(first.positions.size()));
  first.positions.insert(first.positions.end(), second.positions.begin(), second.positions.end());
  first.normals.insert(first.normals.end(), second.normals.begin(), second.normals.end());
  s.scene.instances.pop_back();
  Cell cell(cellDevice(device()), s.scene, combine("loop"));
  expectPenumbra(cell, s, "two loops", 20);
}

GPU_TEST(PenumbraCombine, LoopsThatAreNotConvexAreNot) {
  // Declared: what the light's centre lies beyond one edge of does not hide it.
  const PenumbraScene s = star();
  Cell cell(cellDevice(device()), s.scene, combine("loop"));
  const PenumbraErrors e = penumbraErrors(cell, s);
  EXPECT_GT(e.wrong, 5u) << "it is as right as combine=shader";
  EXPECT_LE(e.lighter, 1);
}

GPU_TEST(PenumbraCombine, HalvesOfWedgesAreExactConvexOrNot) {
  for (const PenumbraScene& s :
       {star(), convexSheets(), convexSheets({-0.9, 0.25, -0.5}), convexSheets({0.3, 3.5, 0.5})}) {
    Cell cell(cellDevice(device()), s.scene, combine("split"));
    expectPenumbra(cell, s, "split", 20);
  }
  PenumbraScene s = star();
  s.scene.cameras[0].orthographic = true;
  s.scene.cameras[0].halfHeight = 2.5;
  Cell cell(cellDevice(device()), s.scene, combine("split"));
  expectPenumbra(cell, s, "split, parallel");
}

GPU_TEST(PenumbraCombine, HalvesAgreeWithCountsWhereSumsDoNot) {
  // An edge straight below the light, from an eye in their plane: the middle column of pixels lies
  // in it, but for less than vertices snap to.
  PenumbraScene s = penumbraFloor(ball(0.5, {0, 4, 0}));
  addSheet(s, {0.75 + 4e-5, 1, 0}, {0.75, 0, 0.75}, {-0.75, 0, 0.75}, {1, 1, 1, 1});
  s.scene.cameras[0] = lookAt({0, 3, 6}, {0, 0, 0}, 0.5);
  const auto errors = [&](const char* how) {
    CellOptions options = combine(how);
    options.size = {49, 49};
    Cell cell(cellDevice(device()), s.scene, options);
    return penumbraErrors(cell, s);
  };
  EXPECT_GT(errors("float").wrong, 5u) << "they agree: nothing is tested";
  for (const char* how : {"split", "loop"}) {
    const PenumbraErrors e = errors(how);
    // A half goes on for 1/256 of a pixel where the share has begun to fall again.
    EXPECT_LE(e.worst, 2e-3) << how << ", " << e.where;
  }
}

GPU_TEST(PenumbraCombine, BytesHoldNoSharesBelowZero) {
  const TechniqueSet set{&shadowTechnique("PenumbraWedge").info,
                         &transparencyTechnique("Sorted").info, &lightTechnique("AllLights").info};
  for (const char* how : {"loop", "split", "shader"}) {
    const Knobs knobs = Knobs::resolve(knobsOf(set), {{"combine", how}, {"format", "rgba8"}});
    EXPECT_EQ(unsupported(device(), set, knobs, {}).has_value(), how != std::string("shader"));
  }
}
