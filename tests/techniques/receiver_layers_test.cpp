// Receivers by layer (design, section 2): a technique that answers from depth alone is asked for
// the opaque layer, for each layer of depth peeling and for each layer of the visibility buffer;
// and direct light that a technique replaces.
#include <set>

#include "base/worst.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/truth/tracer.h"
#include "tests/techniques/gpu_cell.h"
#include "tests/techniques/layer_probe.h"

using namespace sb;
using namespace sb::test;

namespace {

/// Two panes, one of which covers a part, over a floor and a box; a light that casts.
Scene panesOverFloor() {
  Scene scene = floorScene();
  scene.ambient = glm::vec3(0);
  const uint32_t pane = add(scene, glass(0.5f, {0.5f, 0.25f, 1}));
  addHorizontal(scene, pane, {0, 0.2f, 0}, 3, 3);
  addHorizontal(scene, pane, {-1, 0.4f, 0}, 1.5f, 3.5f);
  addBox(scene, add(scene, matte({0.2f, 0.8f, 0.4f})), {1, 0, 1}, {2, 0.3f, 2});
  scene.cameras[0] = lookAt({0.5, 5, 4}, {0, 0, 0}, 0.9);
  return scene;
}

/// Layers of surfaces from 1e-3 to 1e6 units before an eye whose planes are 1e9 apart.
Scene deepScene() {
  Scene scene;
  const uint32_t opaque = add(scene, matte()), pane = add(scene, glass(0.5f, glm::vec3(0.5f)));
  for (int i = 0; i < 10; ++i) {
    // Across a part of the picture, tilted, each behind and beside the one before.
    const float z = 2e-3f * std::pow(8.0f, float(i));
    const glm::vec3 center(z * (0.07f * float(i) - 0.3f), z * (0.2f - 0.05f * float(i)), -z);
    addQuad(scene, i % 3 == 0 ? pane : opaque, center, {0.2f * z, 0, 0.1f * z},
            {0, 0.2f * z, 0.07f * z});
  }
  addLight(scene, sun({0.1, -1, -0.3}));
  scene.cameras.push_back(lookAt({0, 0, 0}, {0, 0, -1}, 1.0));
  scene.cameras[0].nearPlane = 1e-3;
  scene.cameras[0].farPlane = 1e6;
  return scene;
}

std::vector<std::string> labels(const FrameResult& frame) {
  std::vector<std::string> labels;
  for (const PassResult& pass : frame.passes) labels.push_back(pass.label);
  return labels;
}

/// Away from silhouettes, where the rasteriser may see another surface than the ray.
bool isInside(const Tracer& truth, uint32_t x, uint32_t y, uint32_t layer, rhi::Extent2D size) {
  const auto here = truth.pointAt(x, y, layer);
  for (const auto& [dx, dy] :
       {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)}) {
    const uint32_t i = x + uint32_t(dx), j = y + uint32_t(dy);
    if (i >= size.width || j >= size.height) continue;
    const auto there = truth.pointAt(i, j, layer);
    if (!there || there->instance != here->instance) return false;
  }
  return true;
}

/// How far positions from depth are off, at most, in steps of N4 (spec 17): the depth's step and 4
/// units of rounding.
double worstPosition(rhi::Device& device, const Scene& scene, rhi::Extent2D size,
                     size_t& receivers) {
  const ShadowEntry probe = positionProbe();
  Cell cell(cellDevice(device), scene,
            {.size = size, .transparency = "DepthPeeling", .entry = &probe});
  const Tracer truth(scene, size.width, size.height);
  const Camera& camera = scene.camera();
  double worst = 0;
  for (uint32_t layer = 0; layer <= VisibilityBuffer::kLayers; ++layer)
    for (uint32_t y = 0; y < size.height; ++y)
      for (uint32_t x = 0; x < size.width; ++x) {
        const float* found = &cell.visibility()[layer][4 * (size_t(y) * size.width + x)];
        const auto point = truth.pointAt(x, y, layer);
        if (!point || found[3] == 0 || !isInside(truth, x, y, layer, size)) continue;
        ++receivers;
        // Along the axis; vertices that snap to 1/256 of a pixel move a tilted plane's depth.
        const double distance = glm::dot(point->position, -glm::dvec3(camera.toWorld[2]));
        const double pixel = 2 * std::tan(camera.fovY / 2) / size.height;
        const double slope = glm::length(glm::cross(point->normal, point->position)) /
                             std::abs(glm::dot(point->normal, point->position));
        const double snapped = camera.orthographic ? 0 : distance * slope * pixel / 64;
        const double step = camera.orthographic ? camera.farPlane * 0x1p-24 : distance * 0x1p-24;
        const double allowed = step + 4 * 0x1p-24 * glm::length(point->position) + snapped;
        for (int c = 0; c < 3; ++c)
          worst = base::worse(worst, std::abs(double(found[c]) - point->position[c]) / allowed);
      }
  return worst;
}

}  // namespace

GPU_TEST(ReceiverLayers, PositionsFromDepthHoldAtAnyDistance) {
  size_t receivers = 0;
  EXPECT_LE(worstPosition(device(), deepScene(), {96, 64}, receivers), 8);
  EXPECT_GT(receivers, 2000u);
  receivers = 0;
  Scene parallel = floorScene();
  addHorizontal(parallel, add(parallel, glass(0.5f, glm::vec3(1))), {1, 0.25f, 0}, 1, 2);
  EXPECT_LE(worstPosition(device(), parallel, {40, 40}, receivers), 2);
  EXPECT_GT(receivers, 1000u);
}

GPU_TEST(ReceiverLayers, WhatTheAnswerIsMadeInMaySharePlaceWithWhatSurfacesAreDrawnInto) {
  // Counts in a float target share it with the total transmittance; in the stencil they do not.
  const auto picture = [&](const char* counter) {
    Cell cell(cellDevice(device()), panesOverFloor(),
              {.technique = "StencilShadowVolume",
               .knobs = {{"counter", counter}},
               .size = {48, 48},
               .transparency = "StochasticTransparency"});
    const bool shares = !cell.renderer().bytesByLabel().contains("total transmittance");
    EXPECT_EQ(shares, std::string(counter) == "float");
    cell.renderAgain();
    return cell.picture().rgba;
  };
  EXPECT_EQ(picture("float"), picture("stencil8"));
}

GPU_TEST(ReceiverLayers, EachLayerOfThePictureIsAskedForByItself) {
  const rhi::Extent2D size{48, 48};
  const auto picture = [&](const ShadowEntry* entry) {
    Cell cell(cellDevice(device()), panesOverFloor(),
              {.technique = "none", .size = size, .transparency = "DepthPeeling", .entry = entry});
    return cell.picture().rgba;
  };
  const std::vector<float> lit = picture(nullptr);
  std::vector<float> sum(lit.size(), 0.0f);
  for (uint32_t layer = 0; layer <= 3; ++layer) {
    const ShadowEntry probe = chosenLayerProbe(layer);
    const std::vector<float> one = picture(&probe);
    float most = 0;
    for (size_t i = 0; i < one.size(); ++i) {
      sum[i] += one[i];
      if (i % 4 != 3) most = base::worse(most, one[i]);
    }
    // The third layer does not exist.
    EXPECT_EQ(most > 0.02f, layer < 3) << layer;
  }
  double worst = 0;
  for (size_t i = 0; i < lit.size(); ++i)
    if (i % 4 != 3) worst = base::worse(worst, std::abs(double(lit[i] - sum[i])));
  EXPECT_LE(worst, 4 * 0x1p-10) << "light of all layers together is that without shadows";
}

GPU_TEST(ReceiverLayers, TheVisibilityBufferAsksForEachLayer) {
  const Scene scene = panesOverFloor();
  for (uint32_t chosen = 0; chosen <= VisibilityBuffer::kLayers; ++chosen) {
    const ShadowEntry probe = chosenLayerProbe(chosen);
    Cell cell(cellDevice(device()), scene,
              {.size = {32, 32}, .transparency = "DepthPeeling", .entry = &probe});
    for (uint32_t layer = 0; layer <= VisibilityBuffer::kLayers; ++layer) {
      const VisibilityImage& image = cell.visibility()[layer];
      for (size_t i = 0; i < image.size(); i += 4)
        if (image[i + 3] == 1)
          EXPECT_EQ(image[i], layer == chosen ? 1.0f : 0.0f) << chosen << " " << layer;
    }
  }
}

GPU_TEST(ReceiverLayers, WithoutLayersTranslucentReceiversAreLitAndSaidToBeUnrepresented) {
  const ShadowEntry probe = chosenLayerProbe(0);
  for (const char* transparency : {"Sorted", "DepthPeeling"}) {
    Cell cell(cellDevice(device()), panesOverFloor(),
              {.size = {32, 32}, .transparency = transparency, .entry = &probe});
    const bool handsOut = std::string(transparency) == "DepthPeeling";
    const auto& missing = cell.renderer().plan().unrepresented;
    EXPECT_EQ(std::ranges::count(missing, Effect::TranslucentReceivers), handsOut ? 0 : 1);
    // Both panes: lit, or in the dark as the probe says.
    std::set<float> answers;
    const VisibilityImage& first = cell.visibility()[1];
    const VisibilityImage& opaque = cell.visibility()[0];
    for (size_t i = 0; i < first.size(); i += 4)
      if (cell.visibility()[2][i + 3] == 1) answers.insert(first[i]);
    EXPECT_EQ(answers, std::set<float>{handsOut ? 0.0f : 1.0f});
    EXPECT_EQ(opaque[4 * (16 * 32 + 16)], 1.0f);
  }
}

GPU_TEST(ReceiverLayers, PassesOfLayersExistForTechniquesThatAsk) {
  const auto passes = [&](const ShadowEntry* entry, const std::string& technique) {
    Cell cell(cellDevice(device()), panesOverFloor(),
              {.technique = technique,
               .knobs = {},
               .size = {32, 32},
               .transparency = "DepthPeeling",
               .entry = entry});
    cell.renderAgain();  // by now the number of layers is known
    return labels(cell.result());
  };
  const ShadowEntry probe = positionProbe();
  const std::vector<std::string> asked = passes(&probe, "none");
  const std::vector<std::string> expected = {
      "depth prepass", "answer 0",    "opaque",      "layer depth", "answer 1",    "peel",
      "slide under",   "layer depth", "answer 2",    "peel",        "slide under", "layer depth",
      "answer 3",      "peel",        "slide under", "composite"};
  EXPECT_EQ(asked, expected);
  const std::vector<std::string> plain = passes(nullptr, "none");
  EXPECT_EQ(plain, (std::vector<std::string>{"opaque", "peel", "slide under", "peel", "slide under",
                                             "peel", "slide under", "composite"}));
}

GPU_TEST(ReceiverLayers, OpaqueSurfacesAtOneDepthShowTheFirst) {
  // As where depth is written while shading: the prepass changes no picture.
  Scene scene = floorScene();
  addHorizontal(scene, add(scene, matte({0.9f, 0.1f, 0.1f})), {0, 0, 0}, 4, 4);
  addBox(scene, 0, {1, 0, 1}, {2, 0.3f, 2});
  const auto picture = [&](const ShadowEntry* entry) {
    Cell cell(cellDevice(device()), scene, {.technique = "none", .size = {32, 32}, .entry = entry});
    return cell.picture().rgba;
  };
  const ShadowEntry probe = chosenLayerProbe(0);
  EXPECT_EQ(picture(nullptr), picture(&probe));
}

GPU_TEST(DirectLight, ATechniqueMayReplaceIt) {
  Scene scene = floorScene();
  scene.ambient = glm::vec3(0);
  scene.materials[0].baseColor = {0.5f, 0.25f, 1, 1};
  scene.materials[0].roughness = 0.75f;
  addBox(scene, 0, {1, 0, 1}, {2, 0.3f, 2});
  const ShadowEntry probe = directProbe();
  Cell cell(cellDevice(device()), scene, {.technique = "none", .size = {16, 16}, .entry = &probe});
  const auto picture = cell.picture().rgba;
  for (size_t i = 0; i < picture.size(); i += 4) {
    EXPECT_NEAR(picture[i], 0.125f, 1e-4);
    EXPECT_NEAR(picture[i + 1], 0.1875f, 1e-4);
    EXPECT_NEAR(picture[i + 2], 1, 1e-3) << "all that is seen faces up";
  }
}
