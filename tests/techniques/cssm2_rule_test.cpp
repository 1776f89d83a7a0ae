// CSSM2 texel by texel: the blocking rule against random numbers of the CPU, order, nesting, alpha
// and t in {0, 1}, formats (spec 04, invariants 3-8).
#include <algorithm>

#include "base/worst.h"
#include "suites/scenes/edit/transform.h"
#include "tests/techniques/cssm2_helpers.h"

using namespace sb;
using namespace sb::test;

namespace {

/// Depth of a horizontal plane in a map of light straight above.
float depthAt(const LightView& view, double height, const Scene& scene) {
  const glm::dvec3 p = glm::dvec3(0, height, 0) - scene.camera().eye() - glm::dvec3(view.origin);
  return float((glm::dmat4(view.toClip) * glm::dvec4(p, 1)).z);
}

/// Index of the triangle of a quad that covers a texel; -1 near the diagonal or outside.
int triangleAt(const Scene& scene, uint32_t instance, const LightView& view, glm::dvec2 uv) {
  const Mesh& mesh = scene.meshes[scene.instances[instance].mesh];
  for (int t = 0; t < 2; ++t) {
    glm::dvec2 c[3];
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 p = glm::dvec3(mesh.positions[mesh.indices[size_t(3 * t + k)]]) -
                           scene.camera().eye() - glm::dvec3(view.origin);
      c[k] = glm::dvec2(glm::dmat4(view.toClip) * glm::dvec4(p, 1)) * 0.5 + 0.5;
    }
    bool inside = true;
    const double area =
        (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (c[1].y - c[0].y);
    for (int k = 0; k < 3; ++k) {
      const glm::dvec2 a = c[k], b = c[(k + 1) % 3];
      const double e = ((b.x - a.x) * (uv.y - a.y) - (uv.x - a.x) * (b.y - a.y)) / area;
      inside &= e > 1e-3;
    }
    if (inside) return t;
  }
  return -1;
}

}  // namespace

GPU_TEST(Cssm2Rule, EveryTexelHoldsTheNearestBlockerOfEachChannel) {
  for (const char* numbers : {"independent", "shared"}) {
    Cell cell(cellDevice(device()), stack({workedA(), workedB()}),
              mapsOnly({{"numbers", numbers}, {"size", "128"}}));
    const Scene& scene = cell.scene();
    const LightView view = cell.lightViews().at(0);
    const auto colours = cell.map("colours");
    const float depths[3] = {depthAt(view, 2, scene), depthAt(view, 1, scene),
                             depthAt(view, 0, scene)};
    size_t checked = 0, worked = 0;
    for (uint32_t y = 0; y < 128; ++y)
      for (uint32_t x = 0; x < 128; ++x) {
        const glm::dvec2 uv = (glm::dvec2(x, y) + 0.5) / 128.0;
        bool blocked[2][3];
        bool known = triangleAt(scene, 0, view, uv) >= 0;
        for (uint32_t layer = 0; layer < 2 && known; ++layer) {
          const int triangle = triangleAt(scene, 1 + layer, view, uv);
          known = triangle >= 0;
          if (!known) break;
          const Material& m = scene.materials[1 + layer];
          const glm::vec3 p = m.overrideAlpha * (glm::vec3(1) - m.overrideTransmission);
          const glm::vec4 xi = numbersOf(scene, 1 + layer, uint32_t(triangle), view, 0, x, y);
          for (int c = 0; c < 3; ++c)
            blocked[layer][c] = xi[std::string(numbers) == "shared" ? 0 : c] < p[c];
        }
        if (!known) continue;
        const float* m = colours.data() + 4 * (size_t(y) * 128 + x);
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(m[c],
                      depths[blocked[0][c]   ? 0
                             : blocked[1][c] ? 1
                                             : 2],
                      1e-5)
              << numbers << " texel " << x << ", " << y << " channel " << c;
        // The texel that spec 04 works out: A blocks green alone, B red alone.
        worked +=
            !blocked[0][0] && blocked[0][1] && !blocked[0][2] && blocked[1][0] && !blocked[1][2];
        ++checked;
      }
    EXPECT_GT(checked, 10000u);
    if (std::string(numbers) == "independent") {
      EXPECT_GT(worked, 100u);
    }
  }
}

GPU_TEST(Cssm2Rule, PermutationIsBitIdentical) {
  Scene scene = stack({workedA(), workedB(), glass(0.3f, {0.5f, 0, 1})});
  addBox(scene, 0, {-1, 0, -1}, {1, 0.5f, 1});
  Cell before(cellDevice(device()), scene, mapsOnly());
  for (const uint64_t seed : {1u, 2u}) {
    Scene permuted = scene;
    permuteScene(permuted, seed);
    Cell after(cellDevice(device()), permuted, mapsOnly());
    EXPECT_EQ(before.map("colours"), after.map("colours"));
    EXPECT_EQ(before.map("depth"), after.map("depth"));
    EXPECT_EQ(before.picture().rgba, after.picture().rgba);
  }
}

GPU_TEST(Cssm2Rule, ChannelsNeverLieBehindTheOpaqueDepth) {
  // Opaque quads between, above and below the panes.
  Scene scene = stack({workedA(), workedB()});
  addHorizontal(scene, 0, {-2, 1.5f, 0}, 1, 1);
  addHorizontal(scene, 0, {2, 2.5f, 0}, 1, 1);
  Cell cell(cellDevice(device()), scene, mapsOnly());
  const auto depths = cell.map("depth"), colours = cell.map("colours");
  size_t nearer = 0;
  for (size_t i = 0; i < depths.size(); ++i)
    for (size_t c = 0; c < 3; ++c) {
      ASSERT_GE(colours[4 * i + c], depths[i]);  // reversed: nearer to the light
      nearer += colours[4 * i + c] > depths[i];
    }
  EXPECT_GT(nearer, depths.size());
}

GPU_TEST(Cssm2Rule, SharedNumbersNestAndGreyStaysGrey) {
  // p = .2, .5, .8: what blocks red blocks green, what blocks green blocks blue.
  Cell nested(cellDevice(device()), stack({glass(1, {0.8f, 0.5f, 0.2f})}),
              mapsOnly({{"numbers", "shared"}}));
  const auto m = nested.map("colours");
  size_t parted = 0;
  for (size_t i = 0; i < m.size(); i += 4) {
    ASSERT_LE(m[i], m[i + 1]);
    ASSERT_LE(m[i + 1], m[i + 2]);
    parted += m[i] < m[i + 2];
  }
  EXPECT_GT(parted, 10000u);
  Cell grey(cellDevice(device()), stack({glass(0.7f, glm::vec3(0.5f)), glass(0.4f, glm::vec3(0))}),
            mapsOnly({{"numbers", "shared"}}));
  const auto g = grey.map("colours");
  for (size_t i = 0; i < g.size(); i += 4) {
    ASSERT_EQ(g[i], g[i + 1]);
    ASSERT_EQ(g[i], g[i + 2]);
  }
}

GPU_TEST(Cssm2Exact, AlphaAndTransmissionOfZeroAndOne) {
  // G10: V = 1, 1, 0, 1 for (alpha, t) = (0,0), (0,1), (1,0), (1,1). The pane at the far corner
  // makes the technique carry colours in every case.
  const float grid[4][3] = {{0, 0, 1}, {0, 1, 1}, {1, 0, 0}, {1, 1, 1}};
  for (const auto& [alpha, t, expected] : grid) {
    Scene scene = floorScene();
    addHorizontal(scene, add(scene, glass(alpha, glm::vec3(t))), {0, 1, 0}, 3, 3);
    addHorizontal(scene, add(scene, workedA()), {3.75f, 1, 3.75f}, 0.125f, 0.125f);
    CellOptions options = single({{"kernel", "3"}});
    options.size = {64, 64};
    Cell cell(cellDevice(device()), scene, options);
    ASSERT_TRUE(cell.hasMap("colours"));
    const Moments m = momentsOf(cell.visibility()[0], cell.size());
    EXPECT_EQ(m.mean, glm::dvec3(expected)) << alpha << " " << t;
    EXPECT_EQ(m.variance, glm::dvec3(0));
    EXPECT_EQ(m.count, 32u * 32u);
  }
}

GPU_TEST(Cssm2Exact, WhatLetsEverythingPassLeavesTheMapAlone) {
  const auto mapWith = [&](std::optional<Material> pane) {
    Scene scene = stack({workedA(), workedB()});
    if (pane) addHorizontal(scene, add(scene, *pane), {0, 1.5f, 0}, 3, 3);
    Cell cell(cellDevice(device()), scene, mapsOnly());
    return cell.map("colours");
  };
  const auto without = mapWith({});
  EXPECT_EQ(without, mapWith(glass(0, glm::vec3(0))));
  EXPECT_EQ(without, mapWith(glass(0, {0.3f, 0.6f, 0.9f})));
  EXPECT_EQ(without, mapWith(glass(1, glm::vec3(1))));
  EXPECT_NE(without, mapWith(glass(0.01f, glm::vec3(0))));
}

GPU_TEST(Cssm2Exact, AlphaOneWithoutTransmissionIsOpaque) {
  // Vertex colours make one half black and solid (p = 1), the other half clear: drawn by MIN, the
  // solid half leaves the same map as an opaque quad.
  const auto mapOf = [&](bool opaque) {
    Scene scene = stack({workedA()});
    Mesh solid = quadMesh(0, {-1, 0.5f, 0}, {0, 0, 1}, {1, 0, 0});
    if (!opaque) {
      Material blend = matte(glm::vec3(1));
      blend.alphaMode = AlphaMode::Blend;
      solid.material = add(scene, blend);
      solid.colors.assign(4, glm::vec4(0, 0, 0, 1));
      Mesh clear = quadMesh(solid.material, {3, 0.5f, 0}, {0, 0, 1}, {0.5f, 0, 0});
      clear.colors.assign(4, glm::vec4(1, 1, 1, 0));
      place(scene, add(scene, clear));
    }
    place(scene, add(scene, solid));
    Cell cell(cellDevice(device()), scene, mapsOnly());
    return cell.map("colours");
  };
  const auto solid = mapOf(true), stochastic = mapOf(false);
  size_t different = 0;
  for (size_t i = 0; i < solid.size(); ++i) different += solid[i] != stochastic[i];
  EXPECT_EQ(different, 0u);
}

GPU_TEST(Cssm2Formats, ChannelsWithinAStepOfTheFullOnes) {
  const Scene scene = stack({workedA(), workedB()});
  Cell full(cellDevice(device()), scene, mapsOnly());
  const auto reference = full.map("colours");
  const std::pair<const char*, double> formats[] = {{"rgba16", 0x1p-16}, {"rgb10a2", 0x1p-10}};
  for (const auto& [format, step] : formats) {
    Cell cell(cellDevice(device()), scene, mapsOnly({{"format", format}}));
    const auto m = cell.map("colours");
    double worst = 0;
    for (size_t i = 0; i < m.size(); ++i)
      worst = base::worse(worst, double(std::abs(m[i] - reference[i])));
    EXPECT_LE(worst, step) << format;
    EXPECT_GT(worst, 0) << format;
  }
}

GPU_TEST(Cssm2Formats, CoarseFormatsKeepTheMeanAndShowNoAcne) {
  for (const char* format : {"rgba16", "rgb10a2"}) {
    Scene scene = stack({workedA(), workedB()});
    scene.lights[0] = sun({0.3, -1, 0.2});
    Cell cell(cellDevice(device()), scene, single({{"format", format}}));
    const auto& layers = cell.visibility();
    EXPECT_EQ(momentsOf(layers[1], cell.size()).mean, glm::dvec3(1)) << format;
    const Moments floor = momentsOf(layers[0], cell.size());
    const glm::dvec3 q(0.552, 0.396, 0.264);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(floor.mean[c], q[c], fourSigma(q[c], double(floor.count))) << format;
  }
}
