// Kinds of random numbers (spec 03): right in the mean over seeds where they claim to be, and wrong
// by what the spec says where they do not; p = 0 and p = 1; strata; textures only when asked for.
#include "suites/scenes/edit/transform.h"
#include "tests/techniques/cssm2_helpers.h"

using namespace sb;
using namespace sb::test;

namespace {

const std::vector<std::string> kRight = {"hash", "texture", "stratified", "blue"};

/// Places that a surface can read a tile at: what a mean over one frame is a sample of.
double places(const std::string& noise, double texels) {
  if (noise == "texture") return std::min(texels, 65536.0);
  return noise == "blue" ? std::min(texels, 4096.0) : texels;
}

/// Share of texels over the floor that hold nothing nearer, in each channel.
glm::dvec3 passed(Cell& cell) {
  const auto depths = cell.map("depth"), colours = cell.map("colours");
  glm::dvec3 sum(0);
  double texels = 0;
  for (size_t i = 0; i < depths.size(); ++i) {
    if (depths[i] <= 0) continue;
    ++texels;
    for (int c = 0; c < 3; ++c) sum[c] += colours[4 * i + size_t(c)] <= depths[i];
  }
  return sum / texels;
}

CellOptions with(const std::string& noise, std::map<std::string, std::string> knobs = {},
                 uint32_t seed = 0) {
  knobs["noise"] = noise;
  CellOptions options = mapsOnly(std::move(knobs));
  options.seed = seed;
  return options;
}

}  // namespace

GPU_TEST(Noise, LayersAreIndependentInEveryRightKind) {
  // Spec 04's worked example over eight seeds. Correlated layers would give .60, .44, .44.
  constexpr uint32_t kSeeds = 8;
  for (const std::string& noise : kRight) {
    glm::dvec3 sum(0);
    for (uint32_t seed = 0; seed < kSeeds; ++seed) {
      Cell cell(cellDevice(device()), stack({workedA(), workedB()}),
                with(noise, {{"size", "256"}}, seed));
      sum += passed(cell);
    }
    const glm::dvec3 q(0.552, 0.396, 0.264);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(sum[c] / kSeeds, q[c], fourSigma(q[c], kSeeds * places(noise, 240 * 240)))
          << noise << " channel " << c;
  }
}

GPU_TEST(Noise, ShiftedValuesWouldGiveNothing) {
  // Two layers of .5, spec 03's invariant 3: .5 means correlated layers, 0 blue noise shifted in
  // value.
  for (const std::string& noise : kRight) {
    double sum = 0;
    for (uint32_t seed = 0; seed < 8; ++seed) {
      const Material half = glass(0.5f, glm::vec3(0));
      Cell cell(cellDevice(device()), stack({half, half}), with(noise, {{"size", "256"}}, seed));
      sum += passed(cell).x / 8;
    }
    EXPECT_NEAR(sum, 0.25, fourSigma(0.25, 8 * places(noise, 240 * 240))) << noise;
  }
}

GPU_TEST(Noise, ZeroNeverAndOneAlwaysBlocks) {
  // One pane that takes all of red and nothing else; strata of one texel draw 0 once in 4096.
  for (const std::string& noise : kRight) {
    Cell cell(cellDevice(device()), stack({glass(1, {0, 1, 1})}), with(noise));
    EXPECT_EQ(passed(cell), glm::dvec3(0, 1, 1)) << noise;
  }
}

GPU_TEST(Noise, TheSourceDocumentsKindBlocksWhereNothingIs) {
  // alpha = 0 blocks one texel in 256; alpha = .5 blocks (floor(127.5) + 1) / 256. The pane at the
  // corner of the floor makes the technique carry colours.
  for (const auto& [alpha, blocks] : {std::pair{0.0f, 1.0 / 256}, {0.5f, 128.0 / 256}}) {
    Scene scene = floorScene();
    addHorizontal(scene, add(scene, glass(alpha, glm::vec3(0))), {0, 1, 0}, 4.5f, 4.5f);
    addHorizontal(scene, add(scene, workedA()), {3.75f, 2, 3.75f}, 0.125f, 0.125f);
    Cell cell(cellDevice(device()), scene, with("source"));
    const auto depths = cell.map("depth"), colours = cell.map("colours");
    double texels = 0, blocked = 0;
    for (uint32_t y = 128; y < 384; ++y)
      for (uint32_t x = 128; x < 384; ++x) {
        const size_t i = size_t(y) * 512 + x;
        ++texels;
        blocked += colours[4 * i] > depths[i];
      }
    EXPECT_NEAR(blocked / texels, blocks, fourSigma(blocks, texels)) << alpha;
  }
}

GPU_TEST(Noise, TheSourceDocumentsPatternDependsOnTheScaleOfTheWorld) {
  // A texel of the map smaller than 1/2048 of a unit: neighbours read one number. In the right
  // kinds every texel draws, whatever the scale (spec 17, G2).
  const auto alike = [&](const char* noise) {
    Scene scene = stack({glass(0.5f, glm::vec3(0))});
    scaleScene(scene, 0x1p-10);
    Cell cell(cellDevice(device()), scene, with(noise));
    const auto depths = cell.map("depth"), colours = cell.map("colours");
    double same = 0, pairs = 0;
    for (uint32_t y = 128; y < 384; ++y)
      for (uint32_t x = 128; x < 384; ++x) {
        const size_t i = size_t(y) * 512 + x;
        same += (colours[4 * i] > depths[i]) == (colours[4 * i + 4] > depths[i + 1]);
        ++pairs;
      }
    return same / pairs;
  };
  EXPECT_NEAR(alike("hash"), 0.5, 0.01);
  EXPECT_NEAR(alike("texture"), 0.5, 0.02);
  EXPECT_GT(alike("source"), 0.9);
}

GPU_TEST(Noise, AWholeBlockOfStrataIsExact) {
  // Of k x k texels of one triangle, floor or ceil of k^2 p are blocked.
  for (const uint32_t k : {3u, 5u, 9u}) {
    Scene scene = floorScene();
    Mesh pane =
        quadMesh(add(scene, glass(1, {0.7f, 0.5f, 0.05f})), {0, 1, 0}, {0, 0, 8}, {8, 0, 0});
    pane.positions = {{-20, 1, -20}, {20, 1, -20}, {0, 1, 30}};  // one triangle over everything
    pane.normals.resize(3);
    pane.indices = {0, 2, 1};
    pane.triangleKeys.resize(1);
    place(scene, add(scene, pane));
    Cell cell(cellDevice(device()), scene, with("stratified", {{"kernel", std::to_string(k)}}));
    const auto depths = cell.map("depth"), colours = cell.map("colours");
    const double p[3] = {1 - double(0.7f), 1 - double(0.5f), 1 - double(0.05f)};
    size_t blocks = 0, varied = 0;
    double first = -1;
    for (uint32_t by = 16 / k + 1; (by + 1) * k < 496; ++by)
      for (uint32_t bx = 16 / k + 1; (bx + 1) * k < 496; ++bx, ++blocks)
        for (int c = 0; c < 3; ++c) {
          double blocked = 0;
          for (uint32_t j = 0; j < k * k; ++j) {
            const size_t i = size_t(by * k + j / k) * 512 + bx * k + j % k;
            blocked += colours[4 * i + size_t(c)] > depths[i];
          }
          ASSERT_LT(std::abs(blocked - k * k * p[c]), 1) << k << " block " << bx << ", " << by;
          const size_t corner = size_t(by * k) * 512 + bx * k;
          if (c == 1) varied += (colours[4 * corner + 1] > depths[corner]) != (first > 0);
          if (c == 1 && first < 0) first = colours[4 * corner + 1] > depths[corner];
        }
    EXPECT_GT(blocks, 2000u);
    // The order of a block is its own: its first texel is blocked in about half of them.
    EXPECT_NEAR(double(varied) / double(blocks), 0.5, 0.1) << k;
  }
}

GPU_TEST(Noise, StrataAndBlueNoiseAverageOutFaster) {
  // Variance of 9 x 9 sums of one layer, anywhere on the map, against q (1 - q) / 81 of the hash. A
  // window over four blocks of strata takes shares f of each: 1 - sum f^2, on average 1 - 4/9.
  for (const auto& [noise, low, high] : {std::tuple{"hash", 0.85, 1.15},
                                         {"texture", 0.85, 1.15},
                                         {"stratified", 0.45, 0.65},
                                         {"blue", 0.0, 0.25}}) {
    Cell cell(cellDevice(device()), stack({glass(0.5f, glm::vec3(0))}),
              with(noise, {{"kernel", "9"}}));
    const auto depths = cell.map("depth"), colours = cell.map("colours");
    double squares = 0, count = 0;
    for (uint32_t y = 40; y + 9 < 470; y += 10)
      for (uint32_t x = 40; x + 9 < 470; x += 10) {
        double sum = 0;
        for (uint32_t j = 0; j < 81; ++j) {
          const size_t i = size_t(y + j / 9) * 512 + x + j % 9;
          sum += colours[4 * i] > depths[i];
        }
        squares += (sum / 81 - 0.5) * (sum / 81 - 0.5);
        ++count;
      }
    const double ratio = squares / count / (0.25 / 81);
    EXPECT_GE(ratio, low) << noise;
    EXPECT_LE(ratio, high) << noise;
  }
}

GPU_TEST(Noise, EveryKindFollowsTheSeedAndNoOrderOfDrawing) {
  Scene scene = stack({workedA(), workedB(), glass(0.3f, {0.5f, 0, 1})});
  for (const char* noise : {"hash", "texture", "stratified", "blue", "source"}) {
    Cell before(cellDevice(device()), scene, with(noise));
    Scene permuted = scene;
    permuteScene(permuted, 1);
    Cell after(cellDevice(device()), permuted, with(noise));
    EXPECT_EQ(before.map("colours"), after.map("colours")) << noise;
    Cell other(cellDevice(device()), scene, with(noise, {}, 1));
    const auto a = before.map("colours"), b = other.map("colours");
    size_t different = 0;
    for (size_t i = 0; i < a.size(); i += 4) different += a[i] != b[i];
    EXPECT_GT(different, 30000u) << noise;
  }
}

GPU_TEST(Noise, ATextureExistsOnlyWhenAskedFor) {
  const std::pair<const char*, uint64_t> kinds[] = {{"hash", 0},
                                                    {"stratified", 0},
                                                    {"texture", 256 * 256 * 4},
                                                    {"blue", 64 * 64 * 4},
                                                    {"source", 2048 * 2048 * 4}};
  for (const char* technique : {"StochasticShadowMap", "CSSM1", "CSSM2"})
    for (const auto& [noise, bytes] : kinds) {
      CellOptions options = with(noise, {{"size", "64"}});
      options.technique = technique;
      Cell cell(cellDevice(device()), stack({workedA()}), options);
      const auto labels = cell.renderer().bytesByLabel();
      EXPECT_EQ(labels.contains("noise") ? labels.at("noise") : 0, bytes) << technique << noise;
      Cell opaque(cellDevice(device()), stack({}), options);
      EXPECT_FALSE(opaque.renderer().bytesByLabel().contains("noise")) << technique << noise;
    }
}

GPU_TEST(Noise, OnlyIndependentNumbersAreTrials) {
  for (const char* technique : {"StochasticShadowMap", "CSSM1", "CSSM2"})
    for (const std::string noise : {"hash", "texture", "stratified", "blue", "source"}) {
      CellOptions options = with(noise, {{"kernel", "5"}, {"size", "64"}});
      options.technique = technique;
      Cell cell(cellDevice(device()), stack({workedA()}), options);
      EXPECT_EQ(cell.renderer().reach(0).trials, noise == "hash" ? 25u : 0u) << technique << noise;
    }
}
