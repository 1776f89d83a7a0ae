// Technique and truth show surfaces at the same pixels: what one of them alone shows leaves the
// error without a trace but its count. On every scene that the program brings and on the small
// files of the tests, in every layer, nothing but pixels at edges may.
#include <algorithm>
#include <filesystem>

#include "suites/metrics/error.h"
#include "suites/scenes/procedural/procedural.h"
#include "suites/truth/tracer.h"
#include "tests/techniques/gpu_cell.h"

using namespace sb;
using namespace sb::test;

namespace {

/// Procedural scenes at their defaults, then files.
std::vector<std::string> allScenes() {
  std::vector<std::string> scenes;
  for (const SceneInfo& info : proceduralScenes()) scenes.push_back(info.name);
  const std::filesystem::path folder = std::filesystem::path(SHADOWBENCH_TEST_SCENES);
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    // Framed from the front, that file's floor is a line.
    scenes.push_back(entry.path().string() +
                     (entry.path().stem() == "panes" ? "?camera:eye=0,12,24,at=0,0,0" : ""));
  std::ranges::sort(scenes);
  return scenes;
}

}  // namespace

GPU_TEST(OneSidedPixels, AreNowhereAwayFromEdges) {
  constexpr rhi::Extent2D kSize = {112, 84};
  const std::vector<std::string> scenes = allScenes();
  EXPECT_GE(scenes.size(), 15u);
  for (const std::string& spec : scenes) {
    SCOPED_TRACE(spec);
    Scene scene = makeScene(spec);
    // Where surfaces are does not depend on how large lights are, and hard shadows cost few rays.
    for (Light& light : scene.lights)
      light.shape = LightShape::Point, light.halfAxes = glm::dmat3(0), light.angularRadius = 0;
    const auto truth = Tracer(scene, kSize.width, kSize.height)
                           .trace({.width = kSize.width, .height = kSize.height});
    Cell cell(cellDevice(device()), scene, {.technique = "none", .size = kSize});
    if (cell.renderer().lights().empty()) {
      EXPECT_NE(spec.find("light_scale0"), spec.npos) << "no light touches what is seen";
      continue;
    }
    const uint32_t light = cell.renderer().lights().front();
    size_t compared = 0;
    for (uint32_t layer = 0; layer < kTruthLayers; ++layer) {
      const auto& edges = truth->edges[light * kTruthLayers + layer];
      const auto& surfaces = truth->surfaces[layer];
      for (size_t p = 0; p < surfaces.size(); ++p) compared += surfaces[p] != 0 && edges[p] == 0;
      EXPECT_EQ(oneSided(cell.visibility()[layer], surfaces, edges), 0u) << "layer " << layer;
      // At edges rasterisers round corners to 1/256 pixel (spec 17, N2). Seen from 1e6 units away,
      // places relative to the eye are floats in steps of 1/16: nearly a pixel of that picture.
      const bool far = spec.find("fartele6") != spec.npos;
      EXPECT_LE(oneSided(cell.visibility()[layer], surfaces), far ? surfaces.size() / 50 : 8u)
          << "layer " << layer;
    }
    EXPECT_GT(compared, 200u);
  }
}
