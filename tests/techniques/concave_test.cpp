// Casters that rise before themselves: their hollow sides recede in depth maps, and nothing else
// does. Bowls over tessellations, kernels and light are hard cases (suites/stability); here are the
// maps themselves, local lights, and what must not change.
#include <cmath>

#include "suites/scenes/procedural/parts/shapes.h"
#include "tests/techniques/gpu_cell.h"

using namespace sb;
using namespace sb::test;

namespace {

const std::vector<std::string> kTechniques = {
    "ShadowMap", "TranslucentShadows", "CompositedTranslucent", "StochasticShadowMap", "CSSM1",
    "CSSM2"};

/// A sheet over [-1,1]^2, its height over x a polyline.
Mesh sheet(uint32_t material, const std::vector<float>& heights) {
  Mesh mesh;
  mesh.material = material;
  for (size_t i = 0; i < heights.size(); ++i)
    for (const float z : {-1.0f, 1.0f}) {
      mesh.positions.push_back({2 * float(i) / float(heights.size() - 1) - 1, heights[i], z});
      mesh.normals.push_back({0, 1, 0});
    }
  for (uint32_t a = 0; a + 3 < mesh.positions.size(); a += 2)
    for (const uint32_t v : {a, a + 1, a + 3, a, a + 3, a + 2}) mesh.indices.push_back(v);
  return mesh;
}

/// Under a sun off the axes, seen from above.
Scene sheetScene(const std::vector<float>& heights, const Material& material = matte()) {
  Scene scene;
  place(scene, add(scene, sheet(add(scene, material), heights)));
  scene.cameras = {downCamera({0, 3, 0}, 0.9, 10)};
  addLight(scene, sun({0.3, -1, 0.2}));
  return scene;
}

const std::vector<float> kValley = {1, 0.5f, 0.2f, 0.05f, 0, 0.05f, 0.2f, 0.5f, 1};
const std::vector<float> kRidge = {-1, -0.5f, -0.2f, -0.05f, 0, -0.05f, -0.2f, -0.5f, -1};

std::vector<float> depthOf(CellDevice& device, const std::vector<float>& heights,
                           const char* bias) {
  Cell cell(device, sheetScene(heights),
            {.knobs = {{"bias", bias}, {"kernel", "3"}}, .size = {64, 64}});
  return cell.map("depth");
}

float least(const VisibilityImage& image) {
  float least = 1;
  for (size_t i = 0; i < image.size(); i += 4)
    if (image[i + 3] > 0) least = std::min({least, image[i], image[i + 1], image[i + 2]});
  return least;
}

}  // namespace

GPU_TEST(Concave, HollowSidesRecedeByTheirSlopeOverTheFilter) {
  const auto exact = depthOf(cellDevice(device()), kValley, "slope");
  const auto receding = depthOf(cellDevice(device()), kValley, "plane");
  const uint32_t size = uint32_t(std::sqrt(double(exact.size())));
  size_t compared = 0;
  for (uint32_t y = 2; y + 2 < size; ++y)
    for (uint32_t x = 2; x + 2 < size; ++x) {
      const auto at = [&](uint32_t i, uint32_t j) { return double(exact[j * size + i]); };
      const double here = at(x, y);
      const double gx = at(x + 1, y) - here, gy = at(x, y + 1) - here;
      // Within a facet: the same slope on either side.
      if (here == 0 || std::abs(gx - (here - at(x - 1, y))) > 1e-6 ||
          std::abs(gy - (here - at(x, y - 1))) > 1e-6)
        continue;
      ++compared;
      EXPECT_NEAR(double(receding[y * size + x]), here - 1.5 * (std::abs(gx) + std::abs(gy)), 2e-5)
          << x << " " << y;
    }
  EXPECT_GT(compared, exact.size() / 8);
}

GPU_TEST(Concave, WhatIsConvexTowardTheLightKeepsItsDepths) {
  EXPECT_EQ(depthOf(cellDevice(device()), kRidge, "plane"),
            depthOf(cellDevice(device()), kRidge, "slope"));
}

GPU_TEST(Concave, FlatAndConvexCastersHaveNoOtherPipelines) {
  const auto pipelines = [&](const Scene& scene, const char* bias) {
    CellDevice fresh(device());
    Cell(fresh, scene, {.knobs = {{"bias", bias}}, .size = {32, 32}});
    return fresh.pipelines.size();
  };
  Scene convex = floorScene();
  addBox(convex, 0, {-1, 0.25f, -1}, {0, 1, 0});
  addLight(convex, pointLight({1.5, 2, -1}, 4));
  EXPECT_EQ(pipelines(convex, "plane"), pipelines(convex, "slope"));
  EXPECT_EQ(pipelines(sheetScene(kValley), "plane"), pipelines(sheetScene(kValley), "slope") + 1);
}

GPU_TEST(Concave, ValleysAreLitUnderEveryKindOfLight) {
  const std::vector<std::pair<const char*, Light>> lights = {
      {"sun", sun({0.3, -1, 0.2})},
      {"spot", spotLight({0.2, 2.5, 0.3}, {-0.1, -1, -0.1}, 1.0, 10)},
      {"point", pointLight({0.2, 2.5, 0.3}, 10)}};
  for (const std::string& technique : kTechniques)
    for (const char* kernel : {"1", "9"})
      for (const auto& [name, light] : lights) {
        Scene scene = sheetScene(kValley);
        scene.lights = {light};
        Cell cell(cellDevice(device()), scene,
                  {.technique = technique, .knobs = {{"kernel", kernel}}, .size = {64, 64}});
        EXPECT_EQ(least(cell.visibility()[0]), 1) << technique << " " << kernel << " " << name;
      }
}

GPU_TEST(Concave, GlassValleysAreLitInEveryVariant) {
  const std::vector<std::pair<std::string, std::map<std::string, std::string>>> variants = {
      {"ShadowMap", {{"compare", "hardware"}, {"translucent", "opaque"}}},
      {"TranslucentShadows", {{"variant", "published"}}},
      {"CompositedTranslucent", {{"partition", "peeled"}}},
      {"StochasticShadowMap", {{"msaa", "4"}}},
      {"StochasticShadowMap", {{"compare", "hardware"}}},
      {"CSSM1", {{"msaa", "4"}}},
      {"CSSM1", {{"layered", "geometry"}}},
      {"CSSM2", {{"msaa", "4"}}},
      {"CSSM2", {{"format", "rgba16"}}}};
  for (const auto& [technique, knobs] : variants) {
    CellOptions options{.technique = technique, .knobs = knobs, .size = {64, 64}};
    options.knobs["kernel"] = "5";
    Cell cell(cellDevice(device()), sheetScene(kValley, glass(0.5f, {0.25f, 0.5f, 0.75f})),
              options);
    EXPECT_EQ(least(cell.visibility()[1]), 1)
        << technique << " " << knobs.begin()->first << ":" << knobs.begin()->second;
  }
}
