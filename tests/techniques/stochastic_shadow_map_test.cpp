// Stochastic shadow maps (spec 03): worked example, invariants, opacity, several samples a texel.
#include "suites/scenes/edit/transform.h"
#include "tests/techniques/cssm2_helpers.h"

using namespace sb;
using namespace sb::test;

namespace {

CellOptions grey(std::map<std::string, std::string> knobs = {}) {
  CellOptions options = single(std::move(knobs));
  options.technique = "StochasticShadowMap";
  return options;
}

Material opacity(float a) { return glass(a, glm::vec3(0)); }

void expectMean(const Moments& m, double q, double trialsPerPixel, const std::string& what) {
  ASSERT_GT(m.count, 1000u) << what;
  EXPECT_NEAR(m.mean.x, q, fourSigma(q, double(m.count) * trialsPerPixel)) << what;
  EXPECT_EQ(m.mean.x, m.mean.y) << what;
  EXPECT_EQ(m.mean.x, m.mean.z) << what;
}

/// Depth map of the floor under a quad, beside panes in a corner that keep the technique
/// stochastic.
std::vector<float> mapUnder(CellDevice& device, std::optional<Material> quad) {
  Scene scene = floorScene();
  addHorizontal(scene, add(scene, workedA()), {3.75f, 1, 3.75f}, 0.125f, 0.125f);
  if (quad) addHorizontal(scene, add(scene, *quad), {-1, 1, 0}, 2, 3);
  CellOptions options = grey();
  options.size = {16, 16};
  return Cell(device, scene, options).map("depth");
}

}  // namespace

GPU_TEST(StochasticShadow, WorkedExample) {
  // Three grey layers of .5, .3, .2: .28 on the floor, .35 between the second and the third.
  Cell cell(cellDevice(device()), stack({opacity(0.5f), opacity(0.3f), opacity(0.2f)}), grey());
  const auto& layers = cell.visibility();
  expectMean(momentsOf(layers[0], cell.size()), 0.28, 1, "floor");
  expectMean(momentsOf(layers[3], cell.size()), 0.35, 1, "third");
  expectMean(momentsOf(layers[2], cell.size()), 0.5, 1, "second");
  EXPECT_EQ(momentsOf(layers[1], cell.size()).mean, glm::dvec3(1));
}

GPU_TEST(StochasticShadow, NoiseOfTheWorkedExample) {
  Cell cell(cellDevice(device()), stack({opacity(0.5f), opacity(0.3f), opacity(0.2f)}),
            grey({{"kernel", "9"}, {"size", "1024"}}));
  const double texel = cell.lightViews().at(0).texelWidth, pixel = 8.0 / 256;
  const Moments m =
      momentsOf(cell.visibility()[0], cell.size(), uint32_t(std::ceil(9 * texel / pixel)));
  EXPECT_NEAR(std::sqrt(m.variance.x), 0.0499, 0.0499 * 2 / std::sqrt(double(m.count)) * 2);
}

GPU_TEST(StochasticShadow, BlocksOfTexelsAreBinomial) {
  // 03, invariant 4: chi-square of sums of 5 x 5 texels, blocked with .3, in seven bins.
  CellOptions options = grey({{"size", "1024"}});
  options.size = {16, 16};
  Cell cell(cellDevice(device()), stack({opacity(0.3f)}), options);
  const auto depths = cell.map("depth");
  float floor = 1, pane = 0;
  for (const float d : depths) {
    if (d > 0) floor = std::min(floor, d);  // 0 is an empty texel
    pane = std::max(pane, d);
  }
  const auto bin = [](int k) { return std::clamp(k - 4, 0, 6); };
  double counts[7] = {}, expected[7] = {}, blocks = 0;
  for (size_t y = 40; y + 5 < 980; y += 5)
    for (size_t x = 40; x + 5 < 980; x += 5, ++blocks) {
      int blocked = 0;
      for (size_t j = 0; j < 25; ++j)
        blocked += depths[(y + j / 5) * 1024 + x + j % 5] > 0.5f * (floor + pane);
      ++counts[bin(blocked)];
    }
  double binomial = std::pow(1 - double(0.3f), 25);
  for (int k = 0; k <= 25; ++k) {
    expected[bin(k)] += blocks * binomial;
    binomial *= double(25 - k) / (k + 1) * double(0.3f) / (1 - double(0.3f));
  }
  double chi2 = 0;
  for (int b = 0; b < 7; ++b)
    chi2 += (counts[b] - expected[b]) * (counts[b] - expected[b]) / expected[b];
  EXPECT_LT(chi2, 29.9) << "six degrees of freedom: exceeded with 4e-5";
}

GPU_TEST(StochasticShadow, HardwareComparisonsKeepTheMeanAndAverageFour) {
  // A tap of four weighs (1-f) and f on each axis: sum of squares 4/9 on average (spec 03, P8).
  Cell cell(cellDevice(device()), stack({opacity(0.5f)}), grey({{"compare", "hardware"}}));
  const Moments m = momentsOf(cell.visibility()[0], cell.size(), 2);
  EXPECT_NEAR(m.mean.x, 0.5, 4 * std::sqrt(0.25 * 4 / 9 / double(m.count)));
  EXPECT_NEAR(m.variance.x / 0.25, 4.0 / 9, 0.05);
}

GPU_TEST(StochasticShadow, OpacityIsLuminanceOrAlpha) {
  // A takes .8 (1 - lum): lum(t) = .2126 x .9 + .7874 x .3.
  const double lum = 0.2126 * 0.9 + 0.7874 * 0.3;
  Cell luminance(cellDevice(device()), stack({workedA()}), grey());
  expectMean(momentsOf(luminance.visibility()[0], luminance.size()), 1 - 0.8 * (1 - lum), 1, "lum");
  Cell alpha(cellDevice(device()), stack({workedA()}), grey({{"opacity", "alpha"}}));
  expectMean(momentsOf(alpha.visibility()[0], alpha.size()), 0.2, 1, "alpha");
}

GPU_TEST(StochasticShadow, CornersOfOpacityAreExact) {
  // 03, invariant 2 and G10: what takes nothing is not there, what takes all is opaque. By alpha
  // alone glass is a wall however clear.
  auto& d = cellDevice(device());
  const auto none = mapUnder(d, {});
  EXPECT_EQ(none, mapUnder(d, glass(0, glm::vec3(0))));
  EXPECT_EQ(none, mapUnder(d, glass(0, {0.2f, 0.5f, 1})));
  EXPECT_EQ(none, mapUnder(d, glass(1, glm::vec3(1))));
  EXPECT_EQ(mapUnder(d, matte()), mapUnder(d, glass(1, glm::vec3(0))));
  EXPECT_NE(none, mapUnder(d, glass(0.01f, glm::vec3(0))));
  Scene clear = stack({glass(1, glm::vec3(0.99f))});
  clear.cameras = floorScene().cameras;  // below the pane, which hides the floor from above
  Cell cell(d, clear, grey({{"opacity", "alpha"}}));
  EXPECT_EQ(momentsOf(cell.visibility()[0], cell.size()).mean, glm::dvec3(0));
}

GPU_TEST(StochasticShadow, GreySurfacesAreCssm2sWithSharedNumbers) {
  // 04, invariant 7, and hidden fragments: opaque quads between the panes.
  Scene scene = stack({glass(0.7f, glm::vec3(0.5f)), opacity(0.4f)});
  addHorizontal(scene, 0, {-2, 1.5f, 0}, 1, 1);
  CellOptions options = mapsOnly();
  options.technique = "StochasticShadowMap";
  Cell one(cellDevice(device()), scene, options);
  Cell three(cellDevice(device()), scene, mapsOnly({{"numbers", "shared"}}));
  const auto depth = one.map("depth"), colours = three.map("colours");
  for (size_t i = 0; i < depth.size(); ++i) ASSERT_EQ(depth[i], colours[4 * i]) << i;
}

GPU_TEST(StochasticShadow, PermutationIsBitIdentical) {
  Scene scene = stack({opacity(0.3f), workedB(), glass(0.3f, {0.5f, 0, 1})});
  addBox(scene, 0, {-1, 0, -1}, {1, 0.5f, 1});
  for (const char* samples : {"1", "4"}) {
    Cell before(cellDevice(device()), scene, grey({{"msaa", samples}}));
    Scene permuted = scene;
    permuteScene(permuted, 1);
    Cell after(cellDevice(device()), permuted, grey({{"msaa", samples}}));
    if (before.hasMap("depth")) {
      EXPECT_EQ(before.map("depth"), after.map("depth"));
    }
    EXPECT_EQ(before.picture().rgba, after.picture().rgba) << samples;
  }
}

GPU_TEST(StochasticSamples, ASubsetIsAsLargeAsItsOpacity) {
  // a = .3 of 4 samples: 1 or, with .2, 2 are blocked. Var(R/M) = .2 x .8 / 16 = .01.
  Cell cell(cellDevice(device()), stack({opacity(0.3f)}), grey({{"msaa", "4"}}));
  const VisibilityImage& v = cell.visibility()[0];
  for (uint32_t y = 64; y < 192; ++y)
    for (uint32_t x = 64; x < 192; ++x) {
      if (x == y || x == 255 - y || x == 256 - y || x == y + 1 || x + 1 == y) continue;  // seams
      const float value = v[4 * (size_t(y) * 256 + x)];
      ASSERT_TRUE(value == 0.75f || value == 0.5f) << value << " at " << x << ", " << y;
    }
  const Moments m = momentsOf(v, cell.size());
  EXPECT_NEAR(m.mean.x, 0.7, 4 * std::sqrt(0.01 / double(m.count)) + 1e-4);
  EXPECT_NEAR(m.variance.x, 0.01, 0.0008);
}

GPU_TEST(StochasticSamples, SubsetsOfLayersAreIndependent) {
  // Two layers of .5 keep two samples each: all four, three or two blocked with 1/6, 4/6, 1/6.
  // Nested masks, as alpha to coverage makes them, block two always.
  Cell cell(cellDevice(device()), stack({opacity(0.5f), opacity(0.5f)}), grey({{"msaa", "4"}}));
  const VisibilityImage& v = cell.visibility()[0];
  double counts[3] = {0, 0, 0}, total = 0;
  for (uint32_t y = 80; y < 140; ++y)  // away from the seam of two triangles
    for (uint32_t x = 180; x < 240; ++x, ++total)
      for (int k = 0; k < 3; ++k) counts[k] += v[4 * (size_t(y) * 256 + x)] == 0.25f * float(k);
  const double expected[3] = {1.0 / 6, 4.0 / 6, 1.0 / 6};
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(counts[k] / total, expected[k], fourSigma(expected[k], total)) << k;
}

GPU_TEST(StochasticSamples, SlopesShowNoAcneAndEdgesAreFiner) {
  for (const char* technique : {"StochasticShadowMap", "CSSM1", "CSSM2"}) {
    Scene scene = floorScene();
    scene.lights[0] = sun({0.9, -1, 0.6});
    // A wide filter has an allowance for curved surfaces, which would hide acne.
    for (const char* kernel : {"1", "3"}) {
      CellOptions options = grey({{"msaa", "4"}, {"kernel", kernel}});
      options.technique = technique;
      Cell plain(cellDevice(device()), scene, options);
      EXPECT_EQ(momentsOf(plain.visibility()[0], plain.size()).mean, glm::dvec3(1)) << technique;
    }
    // The edge of an opaque caster, in quarters of a texel.
    scene = floorScene();
    addHorizontal(scene, 0, {0.51f, 1, 0.3f}, 1, 1);
    CellOptions edge = grey({{"msaa", "4"}, {"size", "64"}});
    edge.technique = technique;
    Cell cell(cellDevice(device()), scene, edge);
    std::set<float> values;
    for (size_t i = 0; i < cell.visibility()[0].size(); i += 4)
      values.insert(cell.visibility()[0][i]);
    EXPECT_GT(values.size(), 2u) << technique;
    for (const float value : values) EXPECT_EQ(value * 4, std::floor(value * 4)) << technique;
  }
}

GPU_TEST(StochasticSamples, Cssm2DrawsEachSampleAnew) {
  // Kernel 1: q (1 - q) / 4, at every receiver.
  Cell cell(cellDevice(device()), stack({workedA(), workedB()}), [&] {
    return single({{"msaa", "4"}});
  }());
  const auto& layers = cell.visibility();
  const glm::dvec3 floor(0.552, 0.396, 0.264), second(0.92, 0.44, 0.44);
  for (const auto& [layer, q] : {std::pair{0, floor}, {2, second}}) {
    const Moments m = momentsOf(layers[size_t(layer)], cell.size());
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(m.mean[c], q[c], fourSigma(q[c], 4 * double(m.count))) << layer << " " << c;
      EXPECT_NEAR(m.variance[c] / (q[c] * (1 - q[c]) / 4), 1, 0.06) << layer << " " << c;
    }
  }
  EXPECT_EQ(momentsOf(layers[1], cell.size()).mean, glm::dvec3(1));
  EXPECT_EQ(cell.renderer().reach(0).trials, 4u);
}

GPU_TEST(StochasticSamples, Cssm1KeepsASubsetInEachChannel) {
  // Worked example of spec 04; a channel of p keeps floor(4 p) or one more: A's green .56 two or
  // three.
  for (const char* layered : {"vertex", "geometry"}) {
    CellOptions options = single({{"msaa", "4"}, {"layered", layered}});
    options.technique = "CSSM1";
    Cell cell(cellDevice(device()), stack({workedA(), workedB()}), options);
    const auto& layers = cell.visibility();
    for (const auto& [layer, q] :
         {std::pair{0, glm::dvec3(0.552, 0.396, 0.264)}, {2, glm::dvec3(0.92, 0.44, 0.44)}}) {
      const Moments m = momentsOf(layers[size_t(layer)], cell.size());
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(m.mean[c], q[c], fourSigma(q[c], 4 * double(m.count))) << layer << " " << c;
        EXPECT_LT(m.variance[c], 0.75 * q[c] * (1 - q[c]) / 4) << layer << " " << c;
      }
    }
    size_t neither = 0;
    for (uint32_t y = 90; y < 130; ++y)  // away from the seam of two triangles
      for (uint32_t x = 170; x < 200; ++x) {
        const float green = layers[2][4 * (size_t(y) * 256 + x) + 1];
        neither += green != 0.5f && green != 0.25f;
      }
    EXPECT_EQ(neither, 0u);
  }
}

GPU_TEST(StochasticSamples, ARefusalIsAnError) {
  const auto make = [&](const char* technique, std::map<std::string, std::string> knobs) {
    knobs["msaa"] = "4";
    CellOptions options = single(std::move(knobs));
    options.technique = technique;
    Cell(cellDevice(device()), stack({workedA()}), options);
  };
  EXPECT_THROW(make("CSSM2", {{"filter", "adaptive"}}), rhi::Error);
  EXPECT_THROW(make("CSSM1", {{"compare", "hardware"}}), rhi::Error);
  EXPECT_THROW(make("StochasticShadowMap", {{"compare", "hardware"}}), rhi::Error);
}
