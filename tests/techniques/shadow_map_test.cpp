// ShadowMap with one directional light: boundaries, range and exactness of the filter, bias (spec
// 01, invariants 1-5; spec 17, G11).
#include <cmath>

#include "base/worst.h"
#include "suites/scenes/edit/framing.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/scenes/procedural/parts/solids.h"
#include "tests/techniques/gpu_cell.h"
#include "tests/techniques/tracer.h"

using namespace sb;
using namespace sb::test;

namespace {

using KnobMap = std::map<std::string, std::string>;

CellOptions manual(KnobMap knobs = {}) {
  knobs.try_emplace("compare", "manual");
  return {.knobs = knobs};
}

/// An opaque quad of half width 1 above the floor's camera, its edges not on those of pixels.
Scene quadOverFloor(float height = 1) {
  Scene scene = floorScene();
  addHorizontal(scene, 0, {0.055f, height, 0.03f}, 1, 1);
  return scene;
}

glm::dvec3 incidence(double degrees) {
  const double a = glm::radians(degrees), azimuth = glm::radians(33.0);
  return {std::sin(a) * std::cos(azimuth), -std::cos(a), std::sin(a) * std::sin(azimuth)};
}

/// Pixels of the first surface whose visibility is not exactly 1.
size_t unlitPixels(Cell& cell) {
  const VisibilityImage& v = cell.visibility()[0];
  size_t count = 0;
  for (size_t i = 0; i < v.size(); i += 4)
    count += v[i + 3] > 0 && (v[i] != 1 || v[i + 1] != 1 || v[i + 2] != 1);
  return count;
}

}  // namespace

GPU_TEST(ShadowMapEdges, BoundaryWithinOneTexel) {
  Cell cell(cellDevice(device()), quadOverFloor(), manual());
  const ShadowCounts c = compareShadows(cell, 0, 1.0);
  EXPECT_EQ(c.wrong, 0u) << c.firstWrong;
  EXPECT_GT(c.dark, 150u);
  EXPECT_GT(c.lit, 3000u);
  EXPECT_LT(c.unsure, 100u);
}

GPU_TEST(ShadowMapEdges, AreaInTheMapWithinHalfATexelOfThePerimeter) {
  Cell cell(cellDevice(device()), quadOverFloor(), manual());
  const double texel = cell.lightViews().at(0).texelWidth;
  double area = 0;
  for (const float d : cell.map("depth")) area += d > 0.75f ? texel * texel : 0;
  EXPECT_NEAR(area, 4, 8 * texel / 2);
}

GPU_TEST(ShadowMapEdges, CasterBeforeTheNearPlaneStillCasts) {
  // The map's depth encloses the floor alone; the quad is clamped to depth 1 and casts all the
  // same.
  Cell cell(cellDevice(device()), quadOverFloor(1000), manual());
  const std::vector<float> depths = cell.map("depth");
  EXPECT_EQ(*std::ranges::max_element(depths), 1);
  const ShadowCounts c = compareShadows(cell, 0, 1.0);
  EXPECT_EQ(c.wrong, 0u) << c.firstWrong;
  EXPECT_GT(c.dark, 150u);
}

GPU_TEST(ShadowMapFilter, PointComparisonsGiveMultiplesOfOneOverTheirNumber) {
  Cell cell(cellDevice(device()), quadOverFloor(), manual({{"kernel", "3"}}));
  const VisibilityImage& v = cell.visibility()[0];
  size_t between = 0;
  for (size_t i = 0; i < v.size(); i += 4) {
    const float ninths = v[i] * 9;
    EXPECT_NEAR(ninths, std::round(ninths), 9 * 2.5 * 0x1p-23) << v[i];  // a division is 2.5 ulp
    EXPECT_GE(v[i], 0);
    EXPECT_LE(v[i], 1);
    between += v[i] > 0 && v[i] < 1;
  }
  EXPECT_GT(between, 20u);
  const ShadowCounts c = compareShadows(cell, 0, 1 + std::sqrt(2.0));
  EXPECT_EQ(c.wrong, 0u) << c.firstWrong;
  EXPECT_GT(c.dark, 150u);
}

GPU_TEST(ShadowMapFilter, HardwareTapsAreExactAwayFromEdges) {
  // Two texels: the footprint of a tap is one texel wider than a comparison's.
  Cell cell(cellDevice(device()), quadOverFloor());
  const ShadowCounts c = compareShadows(cell, 0, 2.0);
  EXPECT_EQ(c.wrong, 0u) << c.firstWrong;
  EXPECT_GT(c.dark, 150u);
  EXPECT_GT(c.lit, 2500u);
}

GPU_TEST(ShadowMapFilter, UnshadowedFloorIsExactlyOne) {
  Cell cell(cellDevice(device()), floorScene(), manual({{"kernel", "3"}}));
  EXPECT_EQ(unlitPixels(cell), 0u);
}

GPU_TEST(ShadowMapBias, NoAcneUpToTheSlopeLimit) {
  struct Case {
    KnobMap knobs;
    double most;
  };
  // The constant bias is made for 45 degrees and says so.
  const Case cases[] = {{{{"compare", "manual"}}, 84},
                        {{{"compare", "hardware"}}, 84},
                        {{{"compare", "manual"}, {"kernel", "9"}}, 84},
                        {{{"compare", "hardware"}, {"kernel", "3"}}, 84},
                        {{{"compare", "manual"}, {"kernel", "3"}, {"bias", "slope"}}, 84},
                        {{{"compare", "manual"}, {"kernel", "3"}, {"bias", "normal"}}, 84},
                        {{{"compare", "manual"}, {"kernel", "3"}, {"bias", "constant"}}, 45}};
  for (const Case& c : cases)
    for (const double degrees : {0.0, 10.0, 20.0, 30.0, 40.0, 45.0, 50.0, 60.0, 70.0, 80.0, 84.0}) {
      if (degrees > c.most) continue;
      Scene scene = floorScene(false);
      addLight(scene, sun(incidence(degrees)));
      Cell cell(cellDevice(device()), scene, {.knobs = c.knobs});
      std::string knobs;
      for (const auto& [name, value] : c.knobs) knobs += name + "=" + value + " ";
      EXPECT_EQ(unlitPixels(cell), 0u) << degrees << " degrees, " << knobs;
    }
}

GPU_TEST(ShadowMapBias, SliversThatClippingLeavesAreLit) {
  // A floor that the picture's edge clips, so that a fan of its polygon holds a sliver: over that a
  // software rasteriser interpolates positions 22 half-ulps off (spec 17, N4 has four a component).
  // The light looks straight down: nothing but rounding is allowed for.
  Scene scene;
  addInstance(scene, "floor", addMesh(scene, cubeMesh("floor", add(scene, matte()))),
              solidAt({0, -0.1, 0}, {6.3, 0.1, 6.3}));
  addLight(scene, pointLight({4.6, 2.8, 2.4}, 14));
  Camera camera;
  camera.fovY = 0.85;
  camera.toWorld = lookFrom({1.5, 5.2, 10.5}, {-0.2, 0.8, -0.8});
  camera.nearPlane = 1;
  camera.farPlane = 30;
  scene.cameras.push_back(camera);
  for (const char* technique : {"ShadowMap", "CSSM2", "CompositedTranslucent"}) {
    Cell cell(cellDevice(device()), scene, {.technique = technique, .size = {160, 120}});
    EXPECT_EQ(unlitPixels(cell), 0u) << technique;
  }
}

GPU_TEST(ShadowMapBias, GrazingLightErrsByAtMostATenthOfIt) {
  // G11: beyond atan(10) visibility may be lost, where N.L < 0.1.
  for (const double degrees : {85.0, 87.0, 89.9}) {
    Scene scene = floorScene(false);
    addLight(scene, sun(incidence(degrees)));
    scene.ambient = glm::vec3(0);
    Cell with(cellDevice(device()), scene, manual());
    Cell without(cellDevice(device()), scene, {.technique = "none"});
    const auto a = with.picture(), b = without.picture();
    double worst = 0;
    for (size_t i = 0; i < a.rgba.size(); ++i)
      worst = base::worse(worst, double(std::abs(a.rgba[i] - b.rgba[i])));
    EXPECT_LE(worst, 0.1 * scene.lights[0].intensity) << degrees;
    const double cosine = std::cos(glm::radians(degrees));
    for (const float x : with.visibility()[0]) {
      ASSERT_TRUE(x >= 0 && x <= 1) << x;
      ASSERT_LE((1 - x) * cosine, 0.1) << degrees;
    }
  }
}

GPU_TEST(ShadowMapBias, NothingLeaksBeyondTwiceTheBias) {
  // A quad parallel to the floor under light at 45 degrees, so near that its light-space distance
  // is 2.1 biases: slope / 64 and the quantisation of the lookup (shaders/common/light_space.glsl).
  for (const double degrees : {0.0, 45.0, 80.0}) {
    Scene scene = floorScene(false);
    addLight(scene, sun(incidence(degrees)));
    const Cell probe(cellDevice(device()), scene, manual());
    const LightView view = probe.lightViews().at(0);
    // Depth of a unit of length along the light, and of a texel's step on the floor.
    const glm::dmat4 toClip(view.toClip);
    const glm::dvec3 along(toClip[0].z, toClip[1].z, toClip[2].z);
    const double perUnit = glm::length(along), texel = view.texelWidth;
    const double slope = std::sqrt(2.0) * texel * std::tan(glm::radians(degrees)) * perUnit;
    // The floor's corners lie within 6 of the eye.
    const double bias = 2.4e-7 * (1 + 256 * slope + 16 * 6 * perUnit) + slope / 64;
    const double height = 2.1 * bias / perUnit * std::cos(glm::radians(degrees));
    addHorizontal(scene, 0, {0, float(height), 0}, 2, 2);
    // The quad covers the floor in the picture; a camera from below sees the floor's other side.
    scene.cameras[0].toWorld =
        glm::dmat4({1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, -0.5, 0, 1});
    Cell cell(cellDevice(device()), scene, manual());
    const ShadowCounts c = compareShadows(cell, 0, 1.0);
    EXPECT_EQ(c.wrong, 0u) << degrees << ": " << c.firstWrong;
    EXPECT_GT(c.dark, 800u) << degrees;
  }
}

GPU_TEST(ShadowMapFormats, EveryDepthFormatIsFreeOfAcneAndCasts) {
  for (const char* format : {"d16", "d24", "d32f"}) {
    Scene scene = floorScene(false);
    addLight(scene, sun(incidence(45)));
    addHorizontal(scene, 0, {0, 1, 0}, 1, 1);
    Cell cell(cellDevice(device()), scene, manual({{"depth", format}}));
    const ShadowCounts c = compareShadows(cell, 0, 1.0);
    EXPECT_EQ(c.wrong, 0u) << format << ": " << c.firstWrong;
    EXPECT_GT(c.dark, 150u) << format;
    EXPECT_GT(c.lit, 2500u) << format;
  }
}

GPU_TEST(ShadowMapKnobs, TranslucentCastersCastNothingOrEverything) {
  Scene scene = floorScene();
  addHorizontal(scene, add(scene, glass(0.5f, glm::vec3(0.5f))), {0, 1, 0}, 1, 1);
  addHorizontal(scene, 0, {2.5f, 1, 0}, 0.5f, 0.5f);
  const auto shadowed = [&](const char* translucent) {
    Cell cell(cellDevice(device()), scene, manual({{"translucent", translucent}}));
    return unlitPixels(cell);
  };
  // 64 pixels over 8 units: 8 x 8 and 16 x 16 pixels of shadow, give or take a row.
  EXPECT_NEAR(double(shadowed("none")), 64, 20);
  EXPECT_NEAR(double(shadowed("opaque")), 64 + 256, 60);
}

GPU_TEST(ShadowMapKnobs, StableFitAndFrontFacesGiveTheSameShadow) {
  Scene scene = floorScene(false);
  addLight(scene, sun(incidence(45)));
  addBox(scene, 0, {-1, 1, -1}, {1, 2, 1});
  for (const KnobMap& knobs : {KnobMap{{"fit", "stable"}}, KnobMap{{"cull", "front"}}}) {
    Cell cell(cellDevice(device()), scene, manual(knobs));
    const ShadowCounts c = compareShadows(cell, 0, 1.0);
    EXPECT_EQ(c.wrong, 0u) << knobs.begin()->first << ": " << c.firstWrong;
    EXPECT_GT(c.dark, 150u) << knobs.begin()->first;
  }
}
