// The tracer and the rasteriser show the same picture where no shadow falls: the shading twin
// (decision D9), textures, facing, camera layers; on scenes of our own and, where they are there, on
// those of others.
#include <filesystem>

#include "base/worst.h"
#include "suites/scenes/procedural/procedural.h"
#include "suites/truth/tracer.h"
#include "tests/techniques/gpu_cell.h"

using namespace sb;
using namespace sb::test;

namespace {

struct Agreement {
  size_t lit = 0, covered = 0, differ = 0;
  float worst = 0;
};

/// Technique `none` against the truth at pixels away from edges whose every layer is fully lit.
Agreement agreement(CellDevice& device, const Scene& scene, rhi::Extent2D size, float tolerance) {
  const auto truth =
      Tracer(scene, size.width, size.height).trace({.width = size.width, .height = size.height});
  Cell cell(device, scene, {.technique = "none", .size = size});
  const report::Picture picture = cell.picture();
  Agreement a;
  for (size_t p = 0; p < truth->imageEdges.size(); ++p) {
    if (truth->imageEdges[p] || truth->surfaces[4][p]) continue;
    bool lit = true;
    for (const auto& v : truth->visibility)
      for (size_t c = 0; c < 3; ++c) lit &= v[4 * p + 3] == 0 || v[4 * p + c] == 1;
    if (!lit) continue;
    ++a.lit;
    a.covered += truth->surfaces[1][p] != 0;
    float worst = 0;
    for (size_t c = 0; c < 3; ++c)
      worst = base::worse(worst, std::abs(picture.rgba[4 * p + c] - truth->image[4 * p + c]));
    a.differ += !(worst <= tolerance);
    a.worst = base::worse(a.worst, worst);
  }
  return a;
}

}  // namespace

GPU_TEST(TruthPicture, EqualsTheRasterisersWhereNoShadowFalls) {
  for (const char* spec : {"layers", "window", "teapot", "spheres_quads:quads=20"}) {
    const Agreement a = agreement(cellDevice(device()), makeScene(spec), {120, 90}, 2.0f / 255);
    EXPECT_GT(a.covered, 500u) << spec;
    EXPECT_EQ(a.differ, 0u) << spec << ": worst " << a.worst << " of " << a.lit << " pixels";
  }
}

GPU_TEST(TruthPicture, EqualsTheRasterisersUnderASky) {
  Scene scene = makeScene("teapot");
  const auto dark = Tracer(scene, 120, 90).image();
  scene.sky = {0.2f, 0.3f, 0.5f};
  EXPECT_NE(Tracer(scene, 120, 90).image(), dark);
  const Agreement a = agreement(cellDevice(device()), scene, {120, 90}, 2.0f / 255);
  EXPECT_GT(a.covered, 500u);
  EXPECT_EQ(a.differ, 0u) << "worst " << a.worst << " of " << a.lit << " pixels";
}

GPU_TEST(TruthPicture, EqualsTheRasterisersOnScenesOfOthers) {
  const std::filesystem::path shared = SHADOWBENCH_SHARED_SCENES;
  // Normal maps, alpha masks, transmission, textures with transforms, vertex colours.
  for (const char* file : {"GlassVaseFlowers/GlassVaseFlowers.glb",
                           "TransmissionTest/TransmissionTest.glb",
                           "AlphaBlendModeTest/AlphaBlendModeTest.glb"}) {
    if (!std::filesystem::exists(shared / file)) {
      std::printf("left out: %s is not there\n", file);
      continue;
    }
    const Agreement a = agreement(cellDevice(device()), makeScene((shared / file).string()),
                                  {360, 270}, 4.0f / 255);
    EXPECT_GT(a.covered, 300u) << file;
    // Filters of rasterisers have 8 fractional bits (spec 17, N8): steep textures differ by more.
    EXPECT_LE(double(a.differ), 0.002 * double(a.lit)) << file << ": worst " << a.worst;
  }
}
