// Glass (decision D8, Effect::ColouredTransparency): weights per channel of what lies behind, in every
// transparency technique, against values worked out by hand and against the truth; scenes without it
// call for nothing. Surfaces that lie over one another in one plane are layers, the same ones as the
// truth's (spec 16).
#include <algorithm>

#include "base/worst.h"
#include "suites/metrics/error.h"
#include "suites/truth/tracer.h"
#include "tests/techniques/transparency_scenes.h"

using namespace sb;
using namespace sb::test;

namespace {

const std::vector<std::string> kAllTransparency = {
    "Sorted", "DepthPeeling", "DualDepthPeeling", "LinkedLists", "StochasticTransparency"};

/// A pane of glass that shines with its own colour whatever the light.
struct Glass {
  glm::vec3 color;
  float alpha, transmission;
  glm::vec3 behind() const { return 1.0f - alpha * (1.0f - transmission * color); }
  glm::vec3 light() const { return alpha * (1 - transmission) * color; }
};

Scene glassStack(const std::vector<Glass>& list, glm::vec3 background) {
  std::vector<Pane> panes(list.size());
  Scene scene = stack(panes, background);
  for (size_t i = 0; i < list.size(); ++i) {
    Material m;
    m.unlit = true;
    m.metallic = 0;
    m.alphaMode = AlphaMode::Blend;
    m.baseColor = glm::vec4(list[i].color, list[i].alpha);
    m.transmission = list[i].transmission;
    scene.materials[i] = m;
  }
  return scene;
}

glm::vec3 composedGlass(const std::vector<Glass>& list, glm::vec3 background) {
  glm::vec3 color = background;
  for (size_t i = list.size(); i-- > 0;) color = list[i].light() + list[i].behind() * color;
  return color;
}

const std::vector<Glass> kPanes = {{{1, 0.25f, 0.5f}, 1, 0.5f},
                                   {{0.25f, 1, 0.75f}, 0.5f, 1},
                                   {{1, 1, 1}, 0.25f, 0},
                                   {{0.5f, 0.75f, 1}, 1, 0.75f},
                                   {{1, 0.5f, 0}, 0.75f, 0.5f}};

/// Panes of glass, of metal and of colour over a floor, with a highlight on them and no shadow.
Scene shopWindow() {
  Scene scene = floorScene(false);
  scene.background = {0.25f, 0.375f, 0.5f};
  struct Kind {
    glm::vec4 base;
    AlphaMode mode;
    float transmission, metallic;
  };
  const Kind kinds[] = {{{1, 1, 1, 0.25f}, AlphaMode::Blend, 0, 0},
                        {{1, 1, 1, 1}, AlphaMode::Opaque, 0.5f, 0},
                        {{1, 1, 1, 0.25f}, AlphaMode::Blend, 0.5f, 0},
                        {{1, 0.75f, 0.5f, 1}, AlphaMode::Opaque, 1, 1},
                        {{1, 0.125f, 0.125f, 1}, AlphaMode::Opaque, 1, 0},
                        {{1, 0, 0, 0.5f}, AlphaMode::Blend, 0, 0},
                        {{0.5f, 1, 0.5f, 1}, AlphaMode::Opaque, 1, 0.5f}};
  for (int i = 0; i < 7; ++i) {
    Material m = matte();
    m.baseColor = kinds[i].base;
    m.alphaMode = kinds[i].mode;
    m.transmission = kinds[i].transmission;
    m.metallic = kinds[i].metallic;
    m.roughness = 0.4f;
    m.attenuationColor = {0.5f, 0.75f, 1};
    m.attenuationDistance = 1;
    m.thickness = i % 2 ? 0.5f : 0;
    const uint32_t material = add(scene, m);
    addQuad(scene, material, {float(i) - 3, 0.75f, 0}, {0.45f, 0, 0.1f}, {0, 0.5f, 0});
    addQuad(scene, material, {float(i) - 2.75f, 0.75f, -0.5f}, {0.45f, 0, -0.1f}, {0, 0.5f, 0});
  }
  addLight(scene, sun({-0.1, -0.4, -1}));
  scene.cameras = {lookAt({0, 1.25, 5}, {0, 0.5, 0}, 0.9)};
  return scene;
}

/// Two tilted panes in one plane, cut into other triangles and placed by other matrices, before a
/// floor, and one in the floor itself.
Scene coincident(bool glassy) {
  Scene scene;
  scene.background = {0.125f, 0.25f, 0.5f};
  const glm::vec3 u(1, 0.375f, 0.125f), v(0.25f, 0.5f, -1);
  Material red = shining({1, 0.25f, 0}, 0.5f), blue = shining({0, 0.25f, 1}, 0.25f);
  if (glassy) {
    red = {};
    red.metallic = 0;
    red.unlit = true;
    red.baseColor = {1, 0.25f, 0.5f, 1};
    red.transmission = 0.5f;
  }
  place(scene, add(scene, quadMesh(add(scene, red), {0, 1, 0}, u, v)));
  Mesh fan = quadMesh(add(scene, blue), {0, 1, 0}, u, v);
  fan.positions.push_back({0, 1, 0});
  fan.normals.push_back(fan.normals[0]);
  fan.indices = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  for (glm::vec3& p : fan.positions) p = p * 0.1f;
  place(scene, add(scene, std::move(fan)),
        glm::dmat4(10, 0, 0, 0, 0, 10, 0, 0, 0, 0, 10, 0, 0, 0, 0, 1));
  addHorizontal(scene, add(scene, matte()), {0, -1, 0}, 6, 6);
  addHorizontal(scene, 1, {1.7f, -1, 0.3f}, 0.7f, 1.1f);
  addLight(scene, sun({0.1, -1, 0.05}));
  scene.cameras = {lookAt({2.1, 3.3, 4.7}, {0.3, 0.25, 0}, 0.7)};
  return scene;
}

/// Pixels away from edges, of a picture without shadows, that are off; only where the truth is lit.
size_t wrongPixels(const report::Picture& picture, const Truth& truth, float tolerance,
                   size_t* compared = nullptr) {
  size_t wrong = 0;
  for (size_t p = 0; p < truth.imageEdges.size(); ++p) {
    bool lit = truth.imageEdges[p] == 0;
    for (const auto& v : truth.visibility)
      for (size_t c = 0; c < 3; ++c) lit &= v[4 * p + 3] == 0 || v[4 * p + c] == 1;
    if (!lit) continue;
    if (compared) ++*compared;
    float worst = 0;
    for (size_t c = 0; c < 3; ++c)
      worst = base::worse(worst, std::abs(picture.rgba[4 * p + c] - truth.image[4 * p + c]));
    wrong += !(worst <= tolerance);
  }
  return wrong;
}

Truth truthOf(const Scene& scene, rhi::Extent2D size) {
  return *Tracer(scene, size.width, size.height)
              .trace({.width = size.width, .height = size.height});
}

}  // namespace

GPU_TEST(ColouredTransparency, OnePaneIsRightInEveryTechnique) {
  const glm::vec3 background(0.25f, 0.5f, 1);
  for (const Glass& pane : kPanes)
    for (const std::string& t : kAllTransparency) {
      SCOPED_TRACE(t);
      expectColor(rendered(device(), glassStack({pane, kPanes[0]}, background), transparent(t)),
                  composedGlass({pane, kPanes[0]}, background),
                  t == "StochasticTransparency" ? 1.0f : 0x1p-9f);
      if (pane.transmission > 0)
        expectColor(rendered(device(), glassStack({pane}, background), transparent(t)),
                    composedGlass({pane}, background), 0x1p-9f);
    }
}

GPU_TEST(ColouredTransparency, StacksComposeByChannel) {
  const glm::vec3 background(0.25f, 0.5f, 1);
  for (const std::string t : {"Sorted", "DepthPeeling", "DualDepthPeeling", "LinkedLists"})
    for (size_t k = 1; k <= kPanes.size(); ++k) {
      SCOPED_TRACE(t + " " + std::to_string(k));
      const std::vector<Glass> list(kPanes.begin(), kPanes.begin() + std::ptrdiff_t(k));
      expectColor(rendered(device(), glassStack(list, background), transparent(t)),
                  composedGlass(list, background), 0x1p-10f * float(k + 1));
    }
}

GPU_TEST(ColouredTransparency, StochasticIsRightInTheMean) {
  const glm::vec3 background(0.25f, 0.5f, 1);
  const glm::vec3 expected = composedGlass(kPanes, background);
  for (const char* mode : {"basic", "corrected"})
    for (const char* samples : {"1", "4"}) {
      SCOPED_TRACE(std::string(mode) + samples);
      const auto picture = rendered(
          device(), glassStack(kPanes, background),
          transparent("StochasticTransparency", {{"mode", mode}, {"samples", samples}}, {96, 96}));
      glm::dvec3 sum(0), squares(0);
      const double n = double(picture.size() / 4);
      for (size_t p = 0; p < picture.size() / 4; ++p) {
        const glm::dvec3 c(picture[4 * p], picture[4 * p + 1], picture[4 * p + 2]);
        sum += c / n;
        squares += c * c / n;
      }
      for (int c = 0; c < 3; ++c) {
        const double sd = std::sqrt(std::max(0.0, squares[c] - sum[c] * sum[c]) / n);
        // corrected is biased by construction: it divides by a sum of random weights.
        const double slack = mode == std::string("basic")      ? 1e-3
                             : samples == std::string("4") ? 0.06
                                                           : 0.12;
        EXPECT_NEAR(sum[c], double(expected[c]), 5 * sd + slack) << c;
      }
    }
}

GPU_TEST(ColouredTransparency, GlassEqualsTheTruth) {
  const Scene scene = shopWindow();
  const rhi::Extent2D size{120, 90};
  const Truth truth = truthOf(scene, size);
  for (const std::string t : {"Sorted", "DepthPeeling", "DualDepthPeeling", "LinkedLists"}) {
    Cell cell(cellDevice(device()), scene, transparent(t, {}, size));
    EXPECT_TRUE(cell.renderer().plan().runs(Effect::ColouredTransparency));
    size_t compared = 0;
    EXPECT_EQ(wrongPixels(cell.picture(), truth, 2.0f / 255, &compared), 0u) << t;
    EXPECT_GT(compared, 2000u);
  }
}

GPU_TEST(ColouredTransparency, GreyScenesCallForNothing) {
  for (const Scene& scene : {tangle()})
    for (const std::string& t : kAllTransparency) {
      Cell cell(cellDevice(device()), scene, transparent(t, {}, {32, 24}));
      EXPECT_TRUE(cell.renderer().plan().runs(Effect::CameraTransparency));
      EXPECT_FALSE(cell.renderer().plan().runs(Effect::ColouredTransparency));
      for (const auto& [label, bytes] : cell.renderer().bytesByLabel())
        EXPECT_EQ(label.find("coloured"), label.npos) << label;
    }
}

GPU_TEST(CoplanarSurfaces, AreTheSameLayersAsTheTruths) {
  const rhi::Extent2D size{96, 72};
  const Scene scene = coincident(false);
  const Truth truth = truthOf(scene, size);
  Cell cell(cellDevice(device()), scene, transparent("DepthPeeling", {}, size));
  const auto& layers = cell.visibility();
  size_t second = 0;
  for (uint32_t layer = 0; layer < kTruthLayers; ++layer) {
    EXPECT_EQ(oneSided(layers[layer], truth.surfaces[layer], truth.edges[layer]), 0u) << layer;
    if (layer == 2) second = size_t(std::ranges::count(truth.surfaces[layer], 2));
  }
  EXPECT_GT(second, 100u);
}

GPU_TEST(CoplanarSurfaces, ComposeAsIfAHairApart) {
  const rhi::Extent2D size{96, 72};
  for (const bool glassy : {false, true}) {
    const Scene scene = coincident(glassy);
    const Truth truth = truthOf(scene, size);
    for (const std::string& t : kExactTransparency) {
      Cell cell(cellDevice(device()), scene, transparent(t, {}, size));
      EXPECT_EQ(wrongPixels(cell.picture(), truth, 2.0f / 255), 0u) << t << glassy;
    }
  }
}
