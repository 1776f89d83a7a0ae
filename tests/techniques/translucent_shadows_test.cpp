// Translucent shadows on the drivers: spec 02's worked example, table and invariants, the error
// that remains by construction, and its rows of spec 17.
#include "suites/scenes/edit/transform.h"
#include "tests/techniques/cssm2_helpers.h"

using namespace sb;
using namespace sb::test;

namespace {

CellOptions options(std::map<std::string, std::string> knobs = {}, uint32_t size = 32) {
  return {.technique = "TranslucentShadows", .knobs = std::move(knobs), .size = {size, size}};
}

/// Every pixel of the middle of a layer has this visibility.
void expectUniform(const VisibilityImage& image, glm::dvec3 expected, double tolerance,
                   const std::string& what = "") {
  size_t count = 0;
  for (uint32_t y = 8; y < 24; ++y)
    for (uint32_t x = 8; x < 24; ++x) {
      const float* v = image.data() + 4 * (size_t(y) * 32 + x);
      ASSERT_EQ(v[3], 1) << what;
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(v[c], expected[c], tolerance) << what << " " << c;
      ++count;
    }
  EXPECT_EQ(count, 256u);
}

/// The same floor from below the layers: opaque ones hide nothing.
Scene fromBelow(Scene scene) {
  scene.cameras[0] = downCamera({0, 0.5, 0}, 4, 8);
  return scene;
}

/// A layer of surface colour `c`, for the variant that takes it for transmission.
Material coloured(float alpha, glm::vec3 t) {
  Material m = glass(alpha, t);
  m.baseColor = glm::vec4(t, 1);
  return m;
}

std::vector<Material> worked() {
  return {coloured(0.8f, {0.9f, 0.3f, 0.3f}), coloured(0.5f, {0.2f, 0.8f, 0.2f})};
}

}  // namespace

GPU_TEST(TranslucentShadows, WorkedExampleOfEveryVariant) {
  const std::pair<const char*, glm::dvec3> expected[] = {{"energy", {0.552, 0.396, 0.264}},
                                                         {"seed-product", {0.018, 0.024, 0.006}},
                                                         {"seed-blend", {0.222, 0.324, 0.174}},
                                                         {"published", {0.56, 0.62, 0.32}}};
  for (const auto& [variant, floor] : expected)
    for (const char* order : {"centre", "nearest", "triangle"}) {
      Cell cell(cellDevice(device()), stack(worked()),
                options({{"variant", variant}, {"order", order}}));
      expectUniform(cell.visibility()[0], floor, 1e-3, std::string(variant) + " " + order);
    }
}

GPU_TEST(TranslucentShadows, OnlyBlendsThatDoNotCommuteNeedAnOrder) {
  Scene scene = stack(worked());
  std::swap(scene.instances[1].toWorld, scene.instances[2].toWorld);
  scene.instances[1].toWorld[3].y = -1;  // A and B change places; the order of the file stands
  scene.instances[2].toWorld[3].y = 1;
  const auto floorOf = [&](const char* variant, const char* order) {
    Cell cell(cellDevice(device()), scene, options({{"variant", variant}, {"order", order}}));
    const float* v = cell.visibility()[0].data() + 4 * (16 * 32 + 16);
    return glm::vec3(v[0], v[1], v[2]);
  };
  for (const char* variant : {"energy", "seed-product"})
    EXPECT_EQ(floorOf(variant, "centre"), floorOf(variant, "none"));
  // In the order of the file: A first, then B; from the light B comes first now.
  const glm::vec3 right = floorOf("published", "centre"), wrong = floorOf("published", "none");
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(right[c], glm::vec3(0.84f, 0.42f, 0.36f)[c], 1e-3);
    EXPECT_NEAR(wrong[c], glm::vec3(0.56f, 0.62f, 0.32f)[c], 1e-3);
  }
}

GPU_TEST(TranslucentShadows, OneLayerOfEveryAlphaAndTransmission) {
  // Spec 02's table: what passes, and what the two readings of the source make of it.
  for (const float alpha : {0.0f, 0.25f, 0.5f, 1.0f})
    for (const float t : {0.0f, 0.3f, 0.5f, 1.0f}) {
      const double tau = 1 - double(alpha) * (1 - double(t));
      const double product = alpha == 0 ? 1 : (1 - alpha) * t;  // what is not there is discarded
      const double blend = (1 - alpha) * (1 + alpha * t);
      const std::string what = std::to_string(alpha) + " " + std::to_string(t);
      for (const auto& [variant, expected] :
           {std::pair{"energy", tau}, {"seed-product", product}, {"seed-blend", blend}})
        for (const char* format : {"rgba8", "rgba16f"}) {
          Cell cell(cellDevice(device()), fromBelow(stack({glass(alpha, glm::vec3(t))})),
                    options({{"variant", variant}, {"colour", format}}));
          const bool exact = std::string(variant) == "energy" && (alpha == 0 || alpha == 1) &&
                             (t == 0 || t == 1);  // spec 17, G10
          expectUniform(cell.visibility()[0], glm::dvec3(expected),
                        exact                            ? 0
                        : std::string(format) == "rgba8" ? 1 / 255.0
                                                         : 1e-3,
                        what + variant + format);
        }
    }
}

GPU_TEST(TranslucentShadows, AbsentSurfacesChangeNothing) {
  const auto picture = [&](const Scene& scene) {
    Cell cell(cellDevice(device()), scene, options());
    return cell.visibility()[0];
  };
  EXPECT_EQ(picture(stack({})), picture(stack({glass(0, {0.3f, 0.5f, 0.7f})})));
}

GPU_TEST(TranslucentShadows, ManyLayersRoundAsTheirFormat) {
  const std::vector<Material> layers(20, glass(0.5f, glm::vec3(0.8f)));  // tau .9, .1216 behind 20
  for (const auto& [format, tolerance] :
       {std::pair{"rgba8", 20 / 510.0}, {"rgba16f", 1e-2 * 0.1216}}) {
    Cell cell(cellDevice(device()), stack(layers), options({{"colour", format}}));
    expectUniform(cell.visibility()[0], glm::dvec3(std::pow(0.9, 20)), tolerance, format);
  }
}

GPU_TEST(TranslucentShadows, SurfacesBetweenLayersGetAllOfThem) {
  Cell cell(cellDevice(device()), stack(worked()), options());
  expectUniform(cell.visibility()[1], glm::dvec3(1), 0, "the first layer is lit");
  // Truth on B: (.92, .44, .44). The error that remains by construction.
  expectUniform(cell.visibility()[2], {0.552, 0.396, 0.264}, 1e-3, "B");
  ASSERT_EQ(cell.renderer().plan().unrepresented.size(), 1u);
  EXPECT_EQ(cell.renderer().plan().unrepresented[0], Effect::TranslucentOverlap);
}

GPU_TEST(TranslucentShadows, OpaqueReceiversBeforeTheFirstLayerAreLit) {
  Scene scene = stack({glass(0.5f, glm::vec3(0))});
  addHorizontal(scene, 0, {0, 2, 0}, 4.5f, 4.5f);  // between light and quad: the quad is in shadow
  scene.cameras[0] = downCamera({0, 4, 0}, 4, 12);
  Cell cell(cellDevice(device()), scene, options());
  expectUniform(cell.visibility()[0], glm::dvec3(1), 0);
}

GPU_TEST(TranslucentShadows, CoplanarSheetTintsWhollyOrNot) {
  // A sheet that lies in the plane of the floor, but in other triangles, under a layer: no speckle.
  Scene scene = stack({glass(0.5f, glm::vec3(0.5f))});
  addHorizontal(scene, add(scene, glass(1, {1, 0.5f, 0.25f})), {0.3f, 0, 0.2f}, 3.3f, 2.9f);
  scene.lights[0] = sun({0.31, -1, 0.17});
  Cell cell(cellDevice(device()), fromBelow(scene), options());
  expectUniform(cell.visibility()[0], glm::dvec3(0.75) * glm::dvec3(1, 0.5, 0.25), 1e-3);
}

GPU_TEST(TranslucentShadows, OrderOfTheSourcePlaysNoPart) {
  Scene scene =
      stack({glass(0.5f, {0.5f, 1, 1}), glass(0.25f, {1, 0.5f, 0}), glass(1, {1, 1, 0.5f})});
  Cell before(cellDevice(device()), scene, options());
  for (const uint64_t seed : {1u, 2u}) {
    Scene permuted = scene;
    permuteScene(permuted, seed);
    Cell after(cellDevice(device()), permuted, options());
    const auto a = before.map("colours"), b = after.map("colours");
    for (size_t i = 0; i < a.size(); ++i) ASSERT_NEAR(a[i], b[i], 3 * 0x1p-11 * a[i]) << i;
    EXPECT_EQ(before.map("translucent depth"), after.map("translucent depth"));
  }
}

GPU_TEST(TranslucentShadows, TapsMixBeforeTheyAverage) {
  // A wide filter across the edge of a coloured quad: between white and the colour, never beyond.
  Scene scene = floorScene();
  addHorizontal(scene, add(scene, glass(1, {1, 0.25f, 0})), {2, 1, 0}, 2, 4.5f);
  scene.cameras[0] = downCamera({0, 0.5, 0}, 4, 8);
  Cell cell(cellDevice(device()), scene, options({{"kernel", "15"}, {"size", "64"}}));
  size_t between = 0;
  for (size_t i = 0; i < 32 * 32; ++i) {
    const float* v = cell.visibility()[0].data() + 4 * i;
    EXPECT_EQ(v[0], 1);
    const float share = (1 - v[1]) / 0.75f;
    EXPECT_NEAR(v[2], 1 - share, 2e-3);
    between += share > 0.01f && share < 0.99f;
  }
  EXPECT_GT(between, 64u);
}
