// CSSM2 in the mean (spec 04, invariants 1 and 2; rows of spec 17): transmittance at every receiver
// within 4 sigma, variance q (1 - q) / n, noise that falls as 1/N, independent layers.
#include "tests/techniques/cssm2_helpers.h"

using namespace sb;
using namespace sb::test;

namespace {

void expectMean(const Moments& m, const glm::dvec3& q, const std::string& what) {
  ASSERT_GT(m.count, 4000u) << what;
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(m.mean[c], q[c], fourSigma(q[c], double(m.count))) << what << " channel " << c;
}

/// Share of texels in which the layer 0 of the map holds nothing nearer than `depth` in each channel.
glm::dvec3 passedShare(const std::vector<float>& colours, const std::vector<float>& depths) {
  glm::dvec3 passed(0);
  size_t texels = 0;
  for (size_t i = 0; i < depths.size(); ++i) {
    if (depths[i] <= 0) continue;  // beside the floor
    ++texels;
    for (int c = 0; c < 3; ++c) passed[c] += colours[4 * i + size_t(c)] <= depths[i];
  }
  return passed / double(texels);
}

}  // namespace

GPU_TEST(Cssm2Mean, WorkedExampleAtEveryReceiver) {
  // A over B over the floor. Pixels (1/32) are wider than texels: every pixel draws anew.
  Cell cell(cellDevice(device()), stack({workedA(), workedB()}), single());
  const auto& layers = cell.visibility();
  expectMean(momentsOf(layers[0], cell.size()), {0.552, 0.396, 0.264}, "floor");
  expectMean(momentsOf(layers[2], cell.size()), {0.92, 0.44, 0.44}, "B");
  // A receives no shadow, and none of its own: exactly 1.
  const Moments a = momentsOf(layers[1], cell.size());
  EXPECT_EQ(a.mean, glm::dvec3(1));
  EXPECT_EQ(a.count, 128u * 128u);
}

GPU_TEST(Cssm2Mean, NoiseFallsAsOneOverTheKernel) {
  // Pixels N texels apart or more are independent; the mean of N^2 comparisons has q (1 - q) / N^2.
  const glm::dvec3 q(0.552, 0.396, 0.264);
  for (const uint32_t kernel : {3u, 9u}) {
    Cell cell(cellDevice(device()), stack({workedA(), workedB()}),
              single({{"kernel", std::to_string(kernel)}, {"size", "1024"}}));
    const double texel = cell.lightViews().at(0).texelWidth, pixel = 8.0 / 256;
    const uint32_t stride = uint32_t(std::ceil(kernel * texel / pixel));
    const Moments m = momentsOf(cell.visibility()[0], cell.size(), stride);
    ASSERT_GT(m.count, 1500u);
    for (int c = 0; c < 3; ++c) {
      const double variance = q[c] * (1 - q[c]) / (kernel * kernel);
      EXPECT_NEAR(m.mean[c], q[c], 4 * std::sqrt(variance / double(m.count))) << kernel;
      // The variance of a sample variance of nearly normal values is 2 / n of its square.
      EXPECT_NEAR(m.variance[c] / variance, 1, 4 * std::sqrt(2 / double(m.count)) + 0.01) << kernel;
    }
  }
}

GPU_TEST(Cssm2Mean, SharedNumbersKeepTheMean) {
  Cell cell(cellDevice(device()), stack({workedA(), workedB()}), single({{"numbers", "shared"}}));
  expectMean(momentsOf(cell.visibility()[0], cell.size()), {0.552, 0.396, 0.264}, "floor");
}

GPU_TEST(Cssm2Mean, AHundredLayers) {
  // 0.95^100 = 0.00592: a hash per layer has no period.
  Cell cell(cellDevice(device()), stack(std::vector<Material>(100, glass(0.05f, glm::vec3(0)))),
            mapsOnly());
  const auto depths = cell.map("depth");
  const glm::dvec3 q = passedShare(cell.map("colours"), depths);
  const double expected = std::pow(1 - double(0.05f), 100);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(q[c], expected, fourSigma(expected, 480 * 480)) << c;
}

GPU_TEST(Cssm2Mean, CoplanarIdenticalLayersAreIndependent) {
  Scene scene = stack({glass(0.5f, glm::vec3(0.4f)), glass(0.5f, glm::vec3(0.4f))});
  scene.instances[2].mesh = scene.instances[1].mesh;  // one mesh, twice at one place
  Cell cell(cellDevice(device()), scene, mapsOnly());
  const glm::dvec3 q = passedShare(cell.map("colours"), cell.map("depth"));
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(q[c], 0.49, fourSigma(0.49, 480 * 480)) << c;
}

GPU_TEST(Cssm2Mean, LightsDrawIndependently) {
  // Two suns alike: a texel is passed by both with probability q^2, not q.
  Scene scene = stack({glass(0.5f, glm::vec3(0))});
  addLight(scene, sun({0, -1, 0}));
  Cell cell(cellDevice(device()), scene, mapsOnly());
  const auto depths = cell.map("depth"), a = cell.map("colours", 0), b = cell.map("colours", 1);
  size_t both = 0, texels = 0;
  for (size_t i = 0; i < depths.size(); ++i) {
    if (depths[i] <= 0) continue;
    ++texels;
    both += a[4 * i] <= depths[i] && b[4 * i] <= depths[i];
  }
  EXPECT_NEAR(double(both) / double(texels), 0.25, fourSigma(0.25, double(texels)));
}

GPU_TEST(Cssm2Mean, FacesOfAPointLightDrawIndependently) {
  // One glass triangle under the light fills the lower quarter of all four side faces: the same
  // surface at the same texels, and yet what one face passes says nothing of another.
  Scene scene;
  addBox(scene, add(scene, matte()), {-4, -4, -4}, {4, 4, 4});
  Mesh pane = quadMesh(add(scene, glass(0.5f, glm::vec3(0))), {0, -2, 0}, {0, 0, 64}, {64, 0, 0});
  pane.positions = {{-64, -2, -64}, {0, -2, 128}, {64, -2, -64}};
  pane.normals.resize(3);
  pane.indices = {0, 1, 2};
  place(scene, add(scene, pane));
  addLight(scene, pointLight({0, 0, 0}));
  scene.cameras.push_back(lookAt({3, 3, 3}, {0, 0, 0}, 2.0));
  Cell cell(cellDevice(device()), scene, mapsOnly({{"size", "256"}}));
  constexpr size_t kTexels = 56 * 256;
  std::vector<std::vector<bool>> passed;
  for (const uint32_t face : {0u, 1u, 4u, 5u}) {
    const auto depths = cell.map("depth", face), colours = cell.map("colours", face);
    auto& p = passed.emplace_back();
    for (size_t i = 0; i < kTexels; ++i) p.push_back(colours[4 * i] <= depths[i]);
  }
  for (size_t a = 0; a < passed.size(); ++a)
    for (size_t b = a; b < passed.size(); ++b) {
      size_t both = 0;
      for (size_t i = 0; i < kTexels; ++i) both += passed[a][i] && passed[b][i];
      const double expected = a == b ? 0.5 : 0.25;
      EXPECT_NEAR(double(both) / kTexels, expected, fourSigma(expected, kTexels)) << a << " " << b;
    }
}

GPU_TEST(Cssm2Mean, StochasticReceiverIsUnaffectedByItself) {
  // A pane under slanting light, alone: its own texels block nothing of it (spec 17), exactly.
  Scene scene = stack({glass(0.7f, {0.2f, 0.5f, 0.8f})});
  scene.lights[0] = sun({0.6, -1, 0.35});
  Cell cell(cellDevice(device()), scene, single());
  const Moments m = momentsOf(cell.visibility()[1], cell.size());
  EXPECT_EQ(m.mean, glm::dvec3(1));
  EXPECT_EQ(m.count, 128u * 128u);
}
