// Camera transparency driven to where it breaks (spec 17, rows of 15): many layers, layers that are
// not there or hide all behind them, coplanar and crossing ones. Surfaces shine with their own
// colour, so that light plays no part.
#include <cmath>
#include <random>

#include "suites/scenes/edit/transform.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "suites/stability/case.h"

namespace sb {
namespace {

Material shining(const glm::vec3& color, float alpha) {
  Material m = glass(alpha, glm::vec3(0));
  m.baseColor = glm::vec4(color, 1);
  m.unlit = true;
  return m;
}

struct Layer {
  glm::vec3 color;
  float alpha;
};

/// Layers from front to back before a blue background, seen straight on.
Scene facing(const std::vector<Layer>& layers) {
  Scene scene;
  scene.background = {0, 0, 1};
  for (size_t i = 0; i < layers.size(); ++i)
    addQuad(scene, add(scene, shining(layers[i].color, layers[i].alpha)),
            {0, 0, -0.125f * float(i)}, {8, 0, 0}, {0, 8, 0});
  scene.cameras.push_back(lookAt({0, 0, 3}, {0, 0, 0}, 0.5));
  return scene;
}

glm::dvec3 composited(const std::vector<Layer>& layers) {
  glm::dvec3 out(0, 0, 1);
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer)
    out = glm::dvec3(layer->color) * double(layer->alpha) + out * (1 - double(layer->alpha));
  return out;
}

/// Mean of the picture, over seeds for methods that draw numbers.
glm::dvec3 meanColor(const CaseContext& context, const Scene& scene, uint32_t seeds) {
  glm::dvec3 sum(0);
  for (uint32_t seed = 0; seed < seeds; ++seed) {
    Probe probe(context, scene, {.size = {32, 32}, .seed = seed});
    const report::Picture picture = probe.picture();
    glm::dvec3 mean(0);
    for (size_t i = 0; i < picture.rgba.size(); i += 4)
      mean += glm::dvec3(picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]);
    sum += mean / double(picture.rgba.size() / 4);
  }
  return sum / double(seeds);
}

double largest(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Of a picture of 32 x 32 pixels with at least one draw each; half floats add up otherwise.
double allowed(const CaseContext& context, double layers) {
  return context.transparencyInfo().stochastic ? fourSigma(0.5, 32 * 32) : (layers + 1) * 0x1p-10;
}

Found manyLayers(const CaseContext& context) {
  std::mt19937 random(1);
  std::vector<Layer> layers;
  Found found;
  for (const size_t n : {1u, 2u, 4u, 8u, 16u, 32u, 64u, 128u}) {
    while (layers.size() < n)
      layers.push_back({{float(random() % 5) / 4, float(random() % 5) / 4, float(random() % 5) / 4},
                        float(1 + random() % 5) / 64});
    if (context.quick && n != 2 && n != 16) continue;
    const glm::dvec3 mean = meanColor(context, facing(layers), 1);
    found.curve.push_back(
        {double(n), largest(mean - composited(layers)), allowed(context, double(n))});
  }
  return found;
}

Found absentAndOpaque(const CaseContext& context) {
  Found found;
  double x = 0;
  for (const std::vector<Layer>& layers : {std::vector<Layer>{{{1, 0, 0}, 0}, {{0, 1, 0}, 0}},
                                           std::vector<Layer>{{{1, 0, 0}, 0}, {{0, 1, 0}, 0.5f}},
                                           std::vector<Layer>(10, Layer{{1, 0.5f, 0.25f}, 0})}) {
    const glm::dvec3 mean = meanColor(context, facing(layers), 1);
    const bool draws = layers[1].alpha > 0 && context.transparencyInfo().stochastic;
    found.curve.push_back(
        {x++, largest(mean - composited(layers)), draws ? allowed(context, 2) : 0});
  }
  // An opaque surface before ten others: nothing behind it shows.
  std::vector<Layer> hidden(10, Layer{{0, 1, 0}, 0.5f});
  hidden.insert(hidden.begin(), Layer{{1, 0.5f, 0.25f}, 1});
  const glm::dvec3 mean = meanColor(context, facing(hidden), 1);
  found.curve.push_back({x, largest(mean - glm::dvec3(1, 0.5, 0.25)), 0});
  return found;
}

Found oneColor(const CaseContext& context) {
  // Whatever the weights are, they sum to one.
  Found found;
  for (const float alpha : {0.01f, 0.1f, 0.5f, 0.9f, 0.99f}) {
    const std::vector<Layer> layers(6, Layer{{0, 0, 1}, alpha});
    const glm::dvec3 mean = meanColor(context, facing(layers), 1);
    found.curve.push_back({alpha, largest(mean - glm::dvec3(0, 0, 1)), 7 * 0x1p-10});
  }
  return found;
}

Found coplanar(const CaseContext& context) {
  Scene scene = facing({{{1, 0, 0}, 0.5f}});
  addQuad(scene, scene.meshes.back().material, {0, 0, 0}, {8, 0, 0}, {0, 8, 0});
  const glm::dvec3 expected(0.75, 0, 0.25);
  const glm::dvec3 mean = meanColor(context, scene, 1);
  return {.curve = {{2, largest(mean - expected), allowed(context, 2)}}, .expected = ""};
}

Found onFarPlane(const CaseContext& context) {
  // Depth is exactly 1 there, which must not be taken for an empty pixel.
  Scene scene;
  scene.background = {0, 0, 1};
  addHorizontal(scene, add(scene, shining({1, 0, 0}, 0.5f)), {0, 1, 0}, 8, 8);
  addHorizontal(scene, add(scene, shining({0, 1, 0}, 0.5f)), {0, 0, 0}, 8, 8);
  scene.cameras.push_back(downCamera({0, 2, 0}, 1, 2));
  const glm::dvec3 expected(0.5, 0.25, 0.25);
  const glm::dvec3 mean = meanColor(context, scene, 1);
  return {.curve = {{1, largest(mean - expected), allowed(context, 2)}}, .expected = ""};
}

Found crossing(const CaseContext& context) {
  // Red and green cross in the middle of the picture: each is in front on one half.
  Scene scene;
  scene.background = {0, 0, 1};
  addQuad(scene, add(scene, shining({1, 0, 0}, 0.5f)), {0, 0, 0}, {8, 0, 2}, {0, 8, 0});
  addQuad(scene, add(scene, shining({0, 1, 0}, 0.5f)), {0, 0, 0}, {8, 0, -2}, {0, 8, 0});
  scene.cameras.push_back(lookAt({0, 0, 6}, {0, 0, 0}, 0.5));
  Probe probe(context, std::move(scene), {.size = {32, 32}});
  const report::Picture picture = probe.picture();
  Found found;
  for (const bool right : {false, true}) {
    glm::dvec3 mean(0);
    for (uint32_t y = 0; y < 32; ++y)
      for (uint32_t x = right ? 20 : 0; x < (right ? 32u : 12u); ++x) {
        const float* p = picture.rgba.data() + 4 * (y * 32 + x);
        mean += glm::dvec3(p[0], p[1], p[2]) / (32.0 * 12.0);
      }
    const glm::dvec3 expected = right ? glm::dvec3(0.5, 0.25, 0.25) : glm::dvec3(0.25, 0.5, 0.25);
    const double sigma = fourSigma(0.5, 32 * 12);
    found.curve.push_back({double(right), largest(mean - expected),
                           context.transparencyInfo().stochastic ? sigma : 3 * 0x1p-10});
  }
  return found;
}

Found permuted(const CaseContext& context) {
  Scene scene;
  std::mt19937 random(2);
  const auto unit = [&] { return float(random() % 1000) / 1000; };
  scene.background = {0, 0, 1};
  for (int i = 0; i < 24; ++i)
    addQuad(scene, add(scene, shining({unit(), unit(), unit()}, 0.25f + 0.5f * unit())),
            {2 * unit() - 1, 2 * unit() - 1, -0.0625f * float(i)}, {0.75f, 0, 0}, {0, 0.75f, 0});
  scene.cameras.push_back(lookAt({0, 0, 4}, {0, 0, 0}, 0.7));
  Found found;
  Probe before(context, scene, {.size = {64, 64}});
  for (const uint64_t seed : {1u, 2u, 3u}) {
    Scene other = scene;
    permuteScene(other, seed);
    Probe after(context, std::move(other), {.size = {64, 64}});
    // Weighted sums add half floats in the order of drawing.
    found.curve.push_back({double(seed), pictureDifference(before, after),
                           context.transparencyInfo().stochastic ? 1.0 : 0.0});
  }
  return found;
}

}  // namespace

std::vector<StabilityCase> transparencyCases() {
  const std::string color = "the picture is the composite of the layers (difference)";
  const std::string rounding = "2^-10 a layer, or 4 sigma of the draws";
  return {
      {.id = "camera layers",
       .title = "Many layers before the camera",
       .property = color,
       .reason = rounding,
       .parameter = "layers",
       .logarithmic = true,
       .asks = Asks::Transparency,
       .run = manyLayers},
      {.id = "camera 0/1",
       .title = "Layers that are not there, or hide all others",
       .property = color,
       .reason = "exact",
       .asks = Asks::Transparency,
       .run = absentAndOpaque},
      {.id = "camera energy",
       .title = "Everything of one colour",
       .property = "the picture is that colour (difference)",
       .reason = "2^-10 a layer (half floats)",
       .parameter = "alpha",
       .asks = Asks::Transparency,
       .run = oneColor},
      {.id = "camera coplanar",
       .title = "Two surfaces in one place",
       .property = color,
       .reason = rounding,
       .asks = Asks::Transparency,
       .run = coplanar},
      {.id = "camera far",
       .title = "A surface on the far plane",
       .property = color,
       .reason = rounding,
       .asks = Asks::Transparency,
       .run = onFarPlane},
      {.id = "camera crossing",
       .title = "Surfaces through one another",
       .property = color,
       .reason = rounding,
       .asks = Asks::Transparency,
       .run = crossing},
      {.id = "camera G3",
       .title = "Triangles and meshes permuted",
       .property = "the picture stays (largest difference, 1/255)",
       .reason = "exact; sums of half floats round as they are ordered",
       .asks = Asks::Transparency,
       .run = permuted},
  };
}

}  // namespace sb
