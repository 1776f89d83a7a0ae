// What the CSSM2 tests share: a stack of translucent quads over the floor, its random numbers as
// the CPU computes them, and statistics of single texels and of pixels.
#pragma once

#include <cmath>
#include <set>

#include "shaders/common/shared_hash.h"
#include "suites/scenes/procedural/parts/shapes.h"
#include "tests/techniques/gpu_cell.h"

namespace sb::test {

/// Numbers of one texel for a triangle of an instance, as the light pass of a view draws them.
inline glm::vec4 numbersOf(const Scene& scene, uint32_t instance, uint32_t triangle,
                           const LightView& view, uint32_t seed, uint32_t x, uint32_t y) {
  const Instance& i = scene.instances[instance];
  const Mesh& mesh = scene.meshes[i.mesh];
  const uint32_t key = gpu::surfaceKey(mesh.key, i.key, mesh.triangleKeys[triangle]);
  return gpu::randomNumbers(x, y, key, 0, gpu::pcg4d(glm::uvec4(seed, view.key, 0, 0)).x);
}

/// Mean and variance per channel of a layer of the visibility buffer over pixels that show it.
struct Moments {
  glm::dvec3 mean = glm::dvec3(0);
  glm::dvec3 variance = glm::dvec3(0);
  size_t count = 0;
};

/// Every `stride`-th pixel of the middle half of the picture.
inline Moments momentsOf(const VisibilityImage& image, rhi::Extent2D size, uint32_t stride = 1) {
  Moments m;
  glm::dvec3 squares(0);
  for (uint32_t y = size.height / 4; y < size.height * 3 / 4; y += stride)
    for (uint32_t x = size.width / 4; x < size.width * 3 / 4; x += stride) {
      const float* v = image.data() + 4 * (size_t(y) * size.width + x);
      if (v[3] == 0) continue;
      const glm::dvec3 value(v[0], v[1], v[2]);
      m.mean += value;
      squares += value * value;
      ++m.count;
    }
  m.mean /= double(m.count);
  m.variance = squares / double(m.count) - m.mean * m.mean;
  return m;
}

/// 4 sigma of the mean of n independent draws that are 1 with probability q (spec 17, N7).
inline double fourSigma(double q, double n) { return 4 * std::sqrt(q * (1 - q) / n); }

/// p = alpha (1 - t) of spec 04's worked example.
inline Material workedA() { return glass(0.8f, {0.9f, 0.3f, 0.3f}); }
inline Material workedB() { return glass(0.5f, {0.2f, 0.8f, 0.2f}); }

/// The floor under quads that cover it, from high to low; the camera looks down from above them.
/// Quad i is instance 1 + i at height n - i.
inline Scene stack(const std::vector<Material>& fromTheTop) {
  Scene scene = floorScene();
  const float count = float(fromTheTop.size());
  for (size_t i = 0; i < fromTheTop.size(); ++i)
    addHorizontal(scene, add(scene, fromTheTop[i]), {0, count - float(i), 0}, 4.5f, 4.5f);
  scene.cameras[0] = downCamera({0, count + 1.0, 0}, 4, count + 8.0);
  return scene;
}

/// A map of one texel per comparison: pixels draw from different texels.
inline CellOptions single(std::map<std::string, std::string> knobs = {}) {
  knobs.try_emplace("kernel", "1");
  knobs.try_emplace("size", "512");
  return {.technique = "CSSM2", .knobs = knobs, .size = {256, 256}};
}

/// Maps alone: the picture does not matter.
inline CellOptions mapsOnly(std::map<std::string, std::string> knobs = {}) {
  CellOptions options = single(std::move(knobs));
  options.size = {16, 16};
  return options;
}

}  // namespace sb::test
