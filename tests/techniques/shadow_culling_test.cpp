// Culling of shadow volumes (spec 07, invariant 8): it draws less and changes no bit, wherever the
// world and its lights move; a budget leaves out what matters least, and says so.
#include "suites/scenes/edit/transform.h"
#include "suites/scenes/procedural/procedural.h"
#include "tests/techniques/motion_scenes.h"
#include "tests/techniques/shadow_volume_scenes.h"

using namespace sb;
using namespace sb::test;

namespace {

std::map<std::string, uint64_t> countsOf(Cell& cell) {
  const auto counts = cell.renderer().counts();
  return {counts.begin(), counts.end()};
}

const std::vector<Setting> kCulled = {
    {{"tree", "quadtree"}}, {{"tree", "bvh"}}, {{"tree", "none"}}};

/// All steps of a scene.
void expectSamePictures(rhi::Device& device, const Scene& scene, const std::string& what) {
  Cell all(cellDevice(device), scene, volumes({{"cull", "none"}}, {64, 48}));
  const uint32_t steps = std::max<uint32_t>(1, uint32_t(scene.path.size()));
  std::vector<std::vector<float>> pictures;
  std::vector<uint64_t> drawn;
  for (uint32_t step = 0; step < steps; ++step) {
    if (step > 0) all.renderAgain();
    pictures.push_back(all.picture().rgba);
    drawn.push_back(countsOf(all)["volumes drawn"]);
  }
  for (const Setting& setting : kCulled) {
    Cell cell(cellDevice(device), scene, volumes(setting, {64, 48}));
    bool fewer = false;
    for (uint32_t step = 0; step < steps; ++step) {
      if (step > 0) cell.renderAgain();
      EXPECT_EQ(cell.picture().rgba, pictures[step])
          << what << ", " << setting.begin()->second << ", step " << step;
      const uint64_t here = countsOf(cell)["volumes drawn"];
      EXPECT_LE(here, drawn[step]);
      fewer |= here < drawn[step];
    }
    EXPECT_TRUE(fewer) << what << ": nothing was culled";
  }
}

}  // namespace

GPU_TEST(ShadowCulling, ChangesNoBitOfAMineThatMoves) {
  expectSamePictures(device(), makeScene("mine:lights=30,casters=60,moving=0.5?motion:steps=3"),
                     "carts");
  expectSamePictures(
      device(),
      makeScene("mine:lights=24,casters=40,circling=90?motion:move=0.5,0.2,2,turn=60,steps=3"),
      "lamps and camera");
}

GPU_TEST(ShadowCulling, ChangesNoBitUnderAnyLightAndEye) {
  Scene scene = stage(true);
  // Out of view, and behind the eye; its shadow is not.
  addBox(scene, 0, {-9, 0, -9}, {-8, 1, -8});
  addBox(scene, 0, {3.5f, 4.5f, 4.5f}, {4, 5, 5});
  for (Light& light : scene.lights)
    if (light.type == LightType::Point) light.range = 3;
  expectSamePictures(device(), scene, "stage");
  Scene flat = scene;
  flat.cameras[0] = downCamera({0, 3, 0}, 1, 5);
  expectSamePictures(device(), flat, "orthographic");
}

GPU_TEST(ShadowCulling, IsPartOfFramesInWhichThingsMove) {
  const auto labels = [&](const std::string& spec) {
    Cell cell(cellDevice(device()), makeScene(spec), volumes({}, {64, 48}));
    const FrameResult frame = cell.renderer().frame(FrameMode::Stamped);
    std::vector<std::string> labels;
    for (const PassResult& pass : frame.passes) {
      EXPECT_GT(pass.recordMs, 0) << pass.label;
      labels.push_back(pass.label);
    }
    return labels;
  };
  const auto moving = labels("mine:moving=0.5?motion:steps=2");
  ASSERT_GT(moving.size(), 2u);
  EXPECT_EQ(moving[0], "shadow management");
  EXPECT_EQ(moving[1], "moved");
  const auto standing = labels("mine");
  EXPECT_EQ(std::ranges::count(standing, "shadow management"), 0);
}

GPU_TEST(ShadowCulling, ABudgetKeepsWhatMattersMost) {
  const Scene scene = makeScene("mine:casters=20");
  Cell whole(cellDevice(device()), scene, volumes({}, {64, 48}));
  const uint64_t triangles = countsOf(whole)["caster triangles drawn"];
  ASSERT_GT(triangles, 200u);
  uint64_t before = 0;
  double darker = 0;
  for (const uint64_t budget : {triangles / 4, triangles / 2, triangles}) {
    Cell cell(cellDevice(device()), scene, volumes({{"budget", std::to_string(budget)}}, {64, 48}));
    std::map<std::string, uint64_t> counts = countsOf(cell);
    EXPECT_LE(counts["caster triangles drawn"], budget);
    EXPECT_GT(counts["caster triangles drawn"], before);
    EXPECT_EQ(counts["caster triangles drawn"] + counts["caster triangles over budget"], triangles);
    before = counts["caster triangles drawn"];
    // What is left out leaves light.
    double light = 0;
    for (const float value : cell.picture().rgba) light += value;
    if (darker > 0) EXPECT_LE(light, darker);
    darker = light;
  }
  Cell exact(cellDevice(device()), scene,
             volumes({{"budget", std::to_string(triangles)}}, {64, 48}));
  EXPECT_EQ(exact.picture().rgba, whole.picture().rgba);
}

GPU_TEST(ShadowCulling, ABudgetKeepsTheMostImportantFirst) {
  // A large box near the eye, a small one far from it, in either order: one of them is within 14
  // triangles, even beside the floor.
  const auto dark = [&](bool farFirst, Setting knobs) {
    Scene scene = floorScene(false);
    const auto nearBox = [&] { addBox(scene, 0, {-1, 0.5f, 1}, {1, 1.5f, 2.5f}); };
    if (!farFirst) nearBox();
    addBox(scene, 0, {-0.25f, 0.5f, -3}, {0.25f, 0.75f, -2.5f});
    if (farFirst) nearBox();
    addLight(scene, sun({0.5, -1, 0}));
    scene.cameras[0] = lookAt({-3, 5, 6}, {0, 0, 0});
    Cell cell(cellDevice(device()), scene, volumes(std::move(knobs)));
    const VisibilityImage& image = cell.visibility()[0];
    size_t pixels = 0;
    for (size_t i = 0; i < image.size(); i += 4) pixels += image[i + 3] == 1 && image[i] == 0;
    return pixels;
  };
  for (const bool farFirst : {false, true}) {
    const size_t both = dark(farFirst, {}), kept = dark(farFirst, {{"budget", "14"}});
    EXPECT_LT(kept, both) << "the small one's shadow is left out";
    EXPECT_GT(3 * kept, 2 * both) << "the large one's is not, " << farFirst;
  }
}
