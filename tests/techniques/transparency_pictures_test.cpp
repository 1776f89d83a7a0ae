// Transparency techniques across backends (decision D5), and every pair with a shadow technique.
#include <map>

#include "suites/harness/checks/verify.h"
#include "suites/scenes/procedural/procedural.h"
#include "tests/techniques/transparency_scenes.h"

using namespace sb;
using namespace sb::test;

namespace {

class TransparencyPictures : public testing::TestWithParam<std::string> {};

TEST_P(TransparencyPictures, AgreeAcrossBackends) {
  std::map<std::string, rhi::Device*> devices;
  for (const std::string& backend : gpuBackends())
    if (rhi::Device* device = sharedDevice(backend)) devices[backend] = device;
  if (devices.size() < 2) GTEST_SKIP() << "fewer than two backends start";
  for (const std::string scene : {"layers:resolution=64", "spheres_quads:quads=100", "window"}) {
    std::map<std::string, report::Picture> made;
    for (const auto& [backend, device] : devices) {
      CellOptions options = transparent(GetParam(), {}, {128, 96});
      options.technique = "ShadowMap";
      Cell cell(cellDevice(*device), makeScene(scene), options);
      made[backend] = cell.picture();
      cell.renderAgain();
      EXPECT_EQ(made[backend].rgba, cell.picture().rgba) << "frame to frame: " << scene;
    }
    const report::Picture& first = made.begin()->second;
    for (const auto& [backend, other] : made)
      EXPECT_EQ(pixelsBeyondOneStep(first, other), 0u)
          << backend << ", " << scene << ", at most by " << maxDifference255(first, other);
    const auto [low, high] = std::ranges::minmax_element(first.rgba);
    EXPECT_GT(*high - *low, 0.5f);
  }
  for (const auto& [backend, device] : devices)
    for (const rhi::Message& m : device->takeMessages())
      ADD_FAILURE() << backend << ": " << m.source << " [" << m.rule << "] " << m.text;
}

std::vector<std::string> allTransparency() {
  std::vector<std::string> names;
  for (const TransparencyEntry* t : transparencyTechniques()) names.push_back(t->info.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Together, TransparencyPictures, testing::ValuesIn(allTransparency()),
                         [](const auto& info) { return info.param; });

}  // namespace

GPU_TEST(TransparencyPairs, EveryShadowTechniqueWithEveryTransparency) {
  for (const ShadowEntry* shadow : shadowTechniques()) {
    std::map<bool, std::vector<float>> known;
    for (const std::string& t : allTransparency()) {
      SCOPED_TRACE(shadow->info.name + "+" + t);
      CellOptions options = transparent(t, {}, {48, 32});
      options.technique = shadow->info.name;
      Cell cell(cellDevice(device()), tangle(true), options);
      EXPECT_EQ(countNonFinite(cell.picture()), 0u);
      EXPECT_FALSE(cell.result().passes.empty());
      // Shadows on translucent surfaces are the same whoever puts these in order; those that answer
      // by layers of receivers show some only where layers are handed out.
      if (t == "Sorted" || t == "StochasticTransparency") continue;
      std::vector<float>& sorted =
          known[shadow->info.receiversByLayer && transparencyTechnique(t).info.handsOutLayers];
      if (sorted.empty()) sorted = cell.picture().rgba;
      EXPECT_LE(largestDifference(sorted, cell.picture().rgba), 0x1p-10f * 10);
    }
  }
}
