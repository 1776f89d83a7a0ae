// No driver compiles a shader in a frame that was rendered before: the frame's time would be that
// of the compiler, and memory would grow with each frame (backends/vulkan/pipeline/vk_lavapipe_blocks.h).
#include <fstream>

#include "suites/scenes/procedural/parts/shapes.h"
#include "techniques/render/registry.h"
#include "tests/techniques/gpu_cell.h"

using namespace sb;
using namespace sb::test;

namespace {

/// Anonymous pages with code: what compilers at run time leave behind.
size_t compiledModules() {
  std::ifstream maps("/proc/self/maps");
  size_t count = 0;
  for (std::string line; std::getline(maps, line);)
    count += line.find(" r-xp 00000000 00:00 0") != std::string::npos && line.back() != ']';
  return count;
}

/// Opaque, masked and textured, unlit, translucent and transmissive surfaces.
Scene everyMaterial() {
  Scene scene;
  scene.name = "every material";
  scene.images.push_back({.name = "holes",
                          .width = 2,
                          .height = 2,
                          .rgba = {255, 0, 0, 255, 0, 255, 0, 0, 0, 0, 255, 255, 9, 9, 9, 0}});
  const uint32_t grey = add(scene, matte());
  Material holes = matte();
  holes.alphaMode = AlphaMode::Mask;
  holes.baseColorTexture.image = 0;
  Material shining = matte({1, 0.5f, 0});
  shining.unlit = true;
  Material clear = matte();
  clear.transmission = 0.5f;
  addHorizontal(scene, grey, {0, 0, 0}, 4, 4);
  addBox(scene, add(scene, shining), {-1.5f, 0, -1}, {-0.5f, 1.25f, 0});
  addQuad(scene, add(scene, glass(0.75f, {0.25f, 0.5f, 1})), {0.5f, 1, -0.5f}, {0.75f, 0.25f, 0},
          {0, 0.5f, 0.5f});
  addQuad(scene, add(scene, holes), {-0.5f, 0.5f, 0.75f}, {0.5f, 0, 0.25f}, {0, 0.5f, 0.25f});
  addQuad(scene, add(scene, clear), {0.5f, 0.5f, 0.75f}, {0.5f, 0, 0.25f}, {0, 0.5f, 0.25f});
  scene.cameras.push_back(lookAt({2.5, 3, 4}, {0, 0.25, 0}));
  return scene;
}

Scene lit(Scene scene, uint32_t lights) {
  addLight(scene, sun({0.375, -1, -0.25}));
  for (uint32_t i = 1; i < lights; ++i)
    addLight(scene, i % 2 ? pointLight({1.5, 2.25, 0.1 * i}, 4)
                          : spotLight({-1.5, 3, 0.1 * i}, {0.5, -1, -0.5}, 0.75, 6));
  return scene;
}

void expectSteady(CellDevice& device, const Scene& scene, CellOptions options) {
  SCOPED_TRACE(options.technique + "+" + options.transparency + ", " +
               std::to_string(scene.lights.size()) + " lights");
  Cell cell(device, scene, options);
  const auto asked = [&] {
    cell.renderAgain();
    for (uint32_t light = 0; light < 2 && light < scene.lights.size(); ++light)
      cell.renderer().readVisibility(light);
  };
  asked();
  const size_t before = compiledModules();
  asked();
  EXPECT_EQ(compiledModules(), before);
}

}  // namespace

GPU_TEST(SteadyFrames, NoShaderIsCompiledAgain) {
  CellDevice& cells = cellDevice(device());
  const Scene scene = everyMaterial();
  for (const ShadowEntry* entry : shadowTechniques())
    expectSteady(cells, lit(scene, 1), {.technique = std::string(entry->info.name)});
  for (const auto* entry : transparencyTechniques())
    expectSteady(cells, lit(scene, 1),
                 {.technique = "none", .transparency = std::string(entry->info.name)});
  expectSteady(cells, lit(scene, 3), {.technique = "ShadowMap"});
}
