// Properties that every technique must have (spec 17, G1-G6, G8, G9), for ShadowMap and the
// stochastic ones:
// moved, scaled, permuted, doubled, degenerate and perturbed scenes; finite pictures of any size.
#include <algorithm>
#include <cmath>

#include "suites/harness/checks/verify.h"
#include "suites/scenes/edit/transform.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "tests/techniques/gpu_cell.h"

using namespace sb;
using namespace sb::test;

namespace {

const std::vector<std::string> kTechniques = {"ShadowMap", "StochasticShadowMap", "CSSM1", "CSSM2"};

CellOptions optionsOf(const std::string& technique) {
  CellOptions o{.technique = technique, .knobs = {{"kernel", "3"}}, .size = {96, 64}};
  if (technique == "ShadowMap") o.knobs["compare"] = "manual";
  return o;
}

/// Opaque boxes, tinted panes, a floor. Coordinates are multiples of 1/64.
Scene mixed(bool localLights) {
  Scene scene;
  scene.name = "mixed";
  const uint32_t grey = add(scene, matte()), red = add(scene, matte({0.75f, 0.25f, 0.125f}));
  addHorizontal(scene, grey, {0, 0, 0}, 4, 4);
  addBox(scene, red, {-1.5f, 0, -1}, {-0.5f, 1.25f, 0});
  addBox(scene, red, {0.5f, 0.25f, 0.5f}, {1.25f, 0.75f, 1.5f});
  addQuad(scene, add(scene, glass(0.75f, {0.25f, 0.5f, 1})), {0.5f, 1, -0.5f}, {0.75f, 0.25f, 0},
          {0, 0.5f, 0.5f});
  addQuad(scene, add(scene, glass(0.5f, {1, 0.5f, 0.25f})), {-0.25f, 1.5f, 0.75f}, {0.5f, 0, 0.25f},
          {0, 0.25f, 0.75f});
  addLight(scene, sun({0.375, -1, -0.25}));
  if (localLights) {
    addLight(scene, pointLight({1.5, 2.25, 0.5}, 4));
    addLight(scene, spotLight({-1.5, 3, 1.5}, {0.5, -1, -0.5}, 0.75, 6));
  }
  scene.cameras.push_back(lookAt({2.5, 3, 4}, {0, 0.25, 0}));
  return scene;
}

/// Everything that a cell makes.
struct Result {
  std::vector<float> picture;
  std::vector<std::vector<float>> maps;
};

Result resultOf(CellDevice& device, const Scene& scene, const std::string& technique) {
  Cell cell(device, scene, optionsOf(technique));
  Result r{cell.picture().rgba, {}};
  uint32_t layers = 0;
  for (const LightView& view : cell.lightViews()) layers += view.layer >= 0;
  for (uint32_t layer = 0; layer < layers; ++layer)
    for (const char* label : {"depth", "colours"})
      if (cell.hasMap(label)) r.maps.push_back(cell.map(label, layer));
  return r;
}

size_t differing(const std::vector<float>& a, const std::vector<float>& b) {
  size_t n = a.size() == b.size() ? 0 : a.size() + b.size();
  for (size_t i = 0; n == 0 && i < a.size(); ++i)
    if (a[i] != b[i]) {
      for (size_t j = i; j < a.size(); ++j) n += a[j] != b[j];
      break;
    }
  return n;
}

void expectSame(const Result& a, const Result& b, const std::string& what) {
  ASSERT_EQ(a.maps.size(), b.maps.size()) << what;
  for (size_t i = 0; i < a.maps.size(); ++i)
    EXPECT_EQ(differing(a.maps[i], b.maps[i]), 0u) << what << ", map " << i;
  EXPECT_EQ(differing(a.picture, b.picture), 0u) << what << ", picture";
}

}  // namespace

GPU_TEST(Generic, TranslationIsBitIdentical) {
  for (const std::string& technique : kTechniques) {
    const Result before = resultOf(cellDevice(device()), mixed(true), technique);
    for (const glm::dvec3 offset :
         {glm::dvec3(1e3, 0, 0), glm::dvec3(1e6, -2e6, 3e6), glm::dvec3(1e7, 1e7, 1e7)}) {
      Scene moved = mixed(true);
      translateScene(moved, offset);
      expectSame(before, resultOf(cellDevice(device()), moved, technique),
                 technique + " moved by " + std::to_string(offset.z));
    }
  }
}

GPU_TEST(Generic, ScalingByPowersOfTwoIsBitIdentical) {
  for (const std::string& technique : kTechniques) {
    const Result before = resultOf(cellDevice(device()), mixed(true), technique);
    for (const int k : {-10, 3, 20}) {
      Scene scaled = mixed(true);
      scaleScene(scaled, std::ldexp(1.0, k));
      expectSame(before, resultOf(cellDevice(device()), scaled, technique),
                 technique + " scaled by 2^" + std::to_string(k));
    }
  }
}

GPU_TEST(Generic, PermutationIsBitIdentical) {
  for (const std::string& technique : kTechniques) {
    const Result before = resultOf(cellDevice(device()), mixed(false), technique);
    for (const uint64_t seed : {1u, 2u, 3u}) {
      Scene permuted = mixed(false);
      permuteScene(permuted, seed);
      expectSame(before, resultOf(cellDevice(device()), permuted, technique), technique);
    }
  }
}

GPU_TEST(Generic, PermutedLightsAddUpToTheSamePicture) {
  // The order of a sum of three may cost half-float rounding, no more.
  for (const std::string& technique : kTechniques) {
    Scene permuted = mixed(true);
    permuteScene(permuted, 4);
    Cell a(cellDevice(device()), mixed(true), optionsOf(technique));
    Cell b(cellDevice(device()), permuted, optionsOf(technique));
    EXPECT_LE(maxDifference255(a.picture(), b.picture()), 1) << technique;
  }
}

GPU_TEST(Generic, DuplicatesAndDegenerateTrianglesChangeNothing) {
  for (const std::string& technique : kTechniques) {
    const Result before = resultOf(cellDevice(device()), mixed(true), technique);
    Scene doubled = mixed(true);
    duplicateOpaque(doubled);
    expectSame(before, resultOf(cellDevice(device()), doubled, technique), technique + " doubled");
    Scene degenerate = mixed(true);
    insertDegenerate(degenerate);
    expectSame(before, resultOf(cellDevice(device()), degenerate, technique),
               technique + " degenerate");
  }
}

GPU_TEST(Generic, PerturbationChangesOnlyEdges) {
  // G6, ShadowMap: one coordinate changed by 1e-6 of itself; visibility changes within two pixels
  // of a place where it was not constant, or where the picture has an edge of surfaces.
  CellOptions options = optionsOf("ShadowMap");
  options.knobs = {{"compare", "manual"}};
  Cell before(cellDevice(device()), mixed(false), options);
  Scene moved = mixed(false);
  moved.instances[1].toWorld[3].x += 1.5e-6;
  moved.lights[0].direction = glm::normalize(moved.lights[0].direction + glm::dvec3(4e-7, 0, 0));
  Cell after(cellDevice(device()), moved, options);
  const auto &a = before.visibility()[0], &b = after.visibility()[0];
  const int width = int(options.size.width), height = int(options.size.height);
  size_t far = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const size_t i = 4 * size_t(y * width + x);
      if (a[i] == b[i] && a[i + 3] == b[i + 3]) continue;
      bool edge = false;
      for (int v = std::max(0, y - 2); v <= std::min(height - 1, y + 2); ++v)
        for (int u = std::max(0, x - 2); u <= std::min(width - 1, x + 2); ++u) {
          const size_t j = 4 * size_t(v * width + u);
          edge |= a[j] != a[i] || a[j + 3] != a[i + 3];
        }
      far += !edge;
    }
  EXPECT_EQ(far, 0u);
}

GPU_TEST(Generic, EverythingIsFiniteAndVisibilityBetweenZeroAndOne) {
  for (const std::string& technique : kTechniques) {
    Cell cell(cellDevice(device()), mixed(true), optionsOf(technique));
    EXPECT_EQ(countNonFinite(cell.picture()), 0u);
    ASSERT_EQ(cell.renderer().lights().size(), 3u);
    for (uint32_t light = 0; light < 3; ++light)
      for (const VisibilityImage& layer : cell.visibility(light))
        for (const float v : layer) ASSERT_TRUE(v >= 0 && v <= 1) << v;
  }
}

GPU_TEST(Generic, EmptyScenesAndOddSizes) {
  Scene empty;
  empty.background = {0.25f, 0.5f, 0.75f};
  empty.cameras.push_back(lookAt({0, 0, 3}, {0, 0, 0}));
  Scene unlit = mixed(false);
  unlit.lights.clear();
  Scene triangle = empty;
  Mesh mesh = quadMesh(add(triangle, matte()), {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  mesh.indices.resize(3);
  place(triangle, add(triangle, mesh));
  addLight(triangle, sun({0, -1, -1}));
  Scene lightOnly = empty;
  addLight(lightOnly, sun({0, -1, 0}));
  Scene full = mixed(true);
  for (const std::string& technique : kTechniques)
    for (const Scene* scene : {&empty, &lightOnly, &unlit, &triangle, &full})
      for (const rhi::Extent2D size : {rhi::Extent2D{1, 1}, {1, 4096}, {37, 53}}) {
        if (size.height == 4096 && scene != &full && scene != &empty) continue;
        CellOptions options = optionsOf(technique);
        options.size = size;
        Cell cell(cellDevice(device()), *scene, options);
        const auto picture = cell.picture();
        EXPECT_EQ(countNonFinite(picture), 0u);
        if (scene == &empty || scene == &lightOnly) {
          EXPECT_EQ(picture.rgba[1], 0.5f);
        }
        if (cell.renderer().lights().empty()) continue;
        for (const float v : cell.visibility()[0]) ASSERT_TRUE(v >= 0 && v <= 1);
      }
}
