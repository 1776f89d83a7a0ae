// The filters of ShadowMap and CSSM2 on small maps made by hand: the worked examples of specs 01
// and 04, compare before filter, weights, borders. Depths here rise from the light, as in the specs;
// maps and lookups hold them reversed (techniques/draw/fit/light_views.h).
#include <cmath>

#include "base/worst.h"
#include "shaders/common/shared_slots.h"
#include "suites/scenes/procedural/parts/random.h"
#include "tests/rhi/resource_helpers.h"

using namespace sb;
using namespace sb::test;

namespace {

struct Query {
  Vec4 uvzBias;
  Vec4 gradient = {0, 0, 0, 0};
};

struct Filter {
  bool hardware = false;
  uint32_t kernel = 1;
  bool tent = false;
  bool fetches = false;  ///< taps from four fetches instead
};

rhi::Texture mapOf(rhi::Device& device, uint32_t size, const std::vector<float>& texels,
                   rhi::Format format = rhi::Format::D32Float) {
  const bool depth = format == rhi::Format::D32Float;
  rhi::Texture map = device.createTexture(
      {.label = "test map",
       .kind = rhi::TextureKind::Tex2DArray,
       .format = format,
       .width = size,
       .height = size,
       .use = (depth ? rhi::TextureUse::DepthTarget : rhi::TextureUse::ColorTarget) |
              rhi::TextureUse::Sampled | kCopies});
  std::vector<float> reversed;
  for (const float t : texels) reversed.push_back(1 - t);
  device.upload(map, {}, bytesOf(reversed));
  return map;
}

/// What the filter answers at each place of the map.
std::vector<Vec4> ask(rhi::Device& device, const char* shader, const rhi::Texture& map,
                      Filter filter, const std::vector<Query>& queries) {
  const bool colour = std::string(shader) == "filter_colour";
  // As ShadowMap does: fetches where the device does not filter the format.
  const bool linear = device.formatCaps(rhi::Format::D32Float).linearFilter && !filter.fetches;
  std::vector<rhi::SpecConstant> constants = {
      {17, filter.kernel}, {18, filter.tent}, {19, colour || filter.hardware}};
  if (!colour) constants.push_back({20, !linear});
  rhi::Pipeline pipeline = device.createPipeline(rhi::ComputePipelineDesc{
      .label = shader,
      .compute = &testShaders().get(std::string("techniques/") + shader + ".comp"),
      .constants = constants});
  using A = rhi::AddressMode;
  rhi::Sampler points = device.createSampler({.label = "points",
                                              .filter = rhi::Filter::Nearest,
                                              .addressU = A::ClampToEdge,
                                              .addressV = A::ClampToEdge});
  rhi::Sampler compare =
      device.createSampler({.label = "compare",
                            .filter = linear ? rhi::Filter::Linear : rhi::Filter::Nearest,
                            .addressU = A::ClampToBorder,
                            .addressV = A::ClampToBorder,
                            .border = rhi::BorderColor::TransparentBlack,
                            .compare = rhi::CompareOp::GreaterOrEqual});
  std::vector<Query> reversed = queries;
  for (Query& q : reversed) {
    q.uvzBias[2] = 1 - q.uvzBias[2];
    q.gradient = {-q.gradient[0], -q.gradient[1], 0, 0};
  }
  rhi::Buffer in = bufferOf(device, reversed);
  rhi::Buffer out = bufferOf(device, std::vector<Vec4>(queries.size()));
  frame(device, [&](rhi::CommandList& list) {
    computePass(
        list, pipeline,
        {rhi::textureAt(TEXTURE_TECHNIQUE, map, points),
         rhi::textureAt(TEXTURE_TECHNIQUE + 1, map, colour ? points : compare),
         rhi::storageAt(STORAGE_TECHNIQUE, in), rhi::storageAt(STORAGE_TECHNIQUE + 1, out)},
        {rhi::use(map.id(), rhi::Access::Sampled), rhi::use(in.id(), rhi::Access::StorageRead)},
        {rhi::use(out.id(), rhi::Access::StorageWrite)},
        {uint32_t(queries.size() + 63) / 64, 1, 1});
  });
  return readAll<Vec4>(device, out);
}

/// Spec 01's worked example: rows 1 and 2 hold 0.2, 0.2, 0.8, 0.8; the others too.
std::vector<float> workedRows() {
  std::vector<float> texels;
  for (int y = 0; y < 4; ++y)
    for (const float d : {0.2f, 0.2f, 0.8f, 0.8f}) texels.push_back(d);
  return texels;
}

}  // namespace

GPU_TEST(ShadowFilter, WorkedExampleHardwareTap) {
  // (2.25, 2) of a 4 x 4 map, depth 0.5, bias 0.01: 0.75. Filtering before comparing gives 1.
  rhi::Texture map = mapOf(device(), 4, workedRows());
  const auto v = ask(device(), "filter_depth", map, {.hardware = true},
                     {{.uvzBias = {2.25f / 4, 0.5f, 0.5f, 0.01f}}});
  EXPECT_NEAR(v[0][0], 0.75f, 0x1p-8f);
  const auto fetched = ask(device(), "filter_depth", map, {.hardware = true, .fetches = true},
                           {{.uvzBias = {2.25f / 4, 0.5f, 0.5f, 0.01f}}});
  EXPECT_EQ(fetched[0][0], 0.75f);
}

GPU_TEST(ShadowFilter, WideHardwareFilterIsTheMeanOfItsTaps) {
  // Each tap compares its own four texels with its own depth on a tilted plane; borders included.
  constexpr int kSize = 16;
  Pcg random(2);
  std::vector<float> texels(kSize * kSize);
  for (float& t : texels) t = float(random.uniform());
  rhi::Texture map = mapOf(device(), kSize, texels);
  std::vector<Query> queries;
  for (int i = 0; i < 1024; ++i)
    queries.push_back({.uvzBias = {float(random.uniform()), float(random.uniform()),
                                   float(random.uniform()), float(random.uniform() * 0.01)},
                       .gradient = {float(random.uniform() - 0.5), float(random.uniform() - 0.5)}});
  for (const int kernel : {3, 9})
    for (const bool tent : {false, true}) {
      const auto answers =
          ask(device(), "filter_depth", map,
              {.hardware = true, .kernel = uint32_t(kernel), .tent = tent}, queries);
      double worst = 0;
      for (size_t i = 0; i < queries.size(); ++i) {
        const auto [u, v, z, bias] = queries[i].uvzBias;
        const double gx = queries[i].gradient[0], gy = queries[i].gradient[1];
        const double px = u * kSize - 0.5, py = v * kSize - 0.5;
        const double fx = px - std::floor(px), fy = py - std::floor(py);
        const int h = kernel / 2;
        double lit = 0, total = 0;
        for (int y = -h; y <= h; ++y)
          for (int x = -h; x <= h; ++x) {
            const double w = tent ? (h + 1 - std::abs(x)) * (h + 1 - std::abs(y)) : 1;
            // Lit receivers lie no deeper than the map, which clears to the far plane.
            const double depth = std::min(
                1.0, z + (gx * x + gy * y) / kSize - bias - (std::abs(gx) + std::abs(gy)) / kSize);
            total += w;
            for (int c = 0; c < 4; ++c) {
              const int tx = int(std::floor(px)) + x + (c & 1);
              const int ty = int(std::floor(py)) + y + (c >> 1);
              const bool outside = tx < 0 || ty < 0 || tx >= kSize || ty >= kSize;
              const double share = (c & 1 ? fx : 1 - fx) * (c >> 1 ? fy : 1 - fy);
              if (outside || depth <= texels[size_t(ty * kSize + tx)]) lit += w * share;
            }
          }
        worst = base::worse(worst, std::abs(answers[i][0] - lit / total));
      }
      EXPECT_LT(worst, 1e-5) << kernel << (tent ? " tent" : " box");
    }
}

GPU_TEST(ShadowFilter, WorkedExampleBoxAndTent) {
  // 3 x 3 around column 2: columns 0, 1, 1 of 3. The tent weighs them 1, 2, 1: 3/4.
  rhi::Texture map = mapOf(device(), 4, workedRows());
  const std::vector<Query> at = {{.uvzBias = {2.25f / 4, 0.5f, 0.5f, 0.01f}}};
  EXPECT_FLOAT_EQ(ask(device(), "filter_depth", map, {.kernel = 3}, at)[0][0], 6.0f / 9);
  EXPECT_FLOAT_EQ(ask(device(), "filter_depth", map, {.kernel = 3, .tent = true}, at)[0][0], 0.75f);
}

GPU_TEST(ShadowFilter, HardwareTapEqualsFourComparisonsWeightedBilinearly) {
  // Spec 01, invariant 3, on random depths, borders included: within 2^-8 (N8).
  constexpr int kSize = 16;
  Pcg random(1);
  std::vector<float> texels(kSize * kSize);
  for (float& t : texels) t = float(random.uniform());
  std::vector<Query> queries;
  for (int i = 0; i < 4096; ++i)
    queries.push_back({.uvzBias = {float(random.uniform()), float(random.uniform()),
                                   float(random.uniform()), float(random.uniform() * 0.01)}});
  rhi::Texture map = mapOf(device(), kSize, texels);
  for (const bool fetches : {false, true}) {
    const auto answers =
        ask(device(), "filter_depth", map, {.hardware = true, .fetches = fetches}, queries);
    double worst = 0;
    for (size_t i = 0; i < queries.size(); ++i) {
      const auto [u, v, z, bias] = queries[i].uvzBias;
      const double x = u * kSize - 0.5, y = v * kSize - 0.5;
      const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
      double expected = 0;
      for (int c = 0; c < 4; ++c) {
        const int tx = x0 + (c & 1), ty = y0 + (c >> 1);
        const bool outside = tx < 0 || ty < 0 || tx >= kSize || ty >= kSize;
        const bool lit = outside || z - bias <= texels[size_t(ty * kSize + tx)];
        const double wx = c & 1 ? x - x0 : 1 - (x - x0), wy = c >> 1 ? y - y0 : 1 - (y - y0);
        expected += lit * wx * wy;
      }
      worst = base::worse(worst, std::abs(answers[i][0] - expected));
    }
    RecordProperty(fetches ? "worst_fetched" : "worst_tap", std::to_string(worst));
    EXPECT_LE(worst, 0x1p-8);
  }
}

GPU_TEST(ShadowFilter, EdgesOfTheMapAreHalfOpen) {
  // A map of zeros shadows everything inside; u or v of exactly 1 lies outside, exactly 0 inside.
  rhi::Texture map = mapOf(device(), 4, std::vector<float>(16, 0.0f));
  const std::vector<Query> at = {{.uvzBias = {0, 0, 0.5f, 0}},
                                 {.uvzBias = {1, 0.5f, 0.5f, 0}},
                                 {.uvzBias = {0.5f, 1, 0.5f, 0}},
                                 {.uvzBias = {0.25f, 0.75f, 0.5f, 0}},
                                 {.uvzBias = {0, 0.5f, 0.5f, 0}}};
  const auto point = ask(device(), "filter_depth", map, {}, at);
  const float expected[] = {0, 1, 1, 0, 0};
  for (size_t i = 0; i < at.size(); ++i) EXPECT_EQ(point[i][0], expected[i]) << i;
  // Hardware taps weigh the lit border: a corner 3/4, an edge 1/2, whichever edge.
  const auto tap = ask(device(), "filter_depth", map, {.hardware = true}, at);
  const float weighed[] = {0.75f, 0.5f, 0.5f, 0, 0.5f};
  for (size_t i = 0; i < at.size(); ++i) EXPECT_NEAR(tap[i][0], weighed[i], 0x1p-8f) << i;
}

GPU_TEST(ShadowFilter, ReceiverPlaneCarriesDepthToEachTap) {
  // Depth rises by 0.1 a texel along u, as the lit plane stored it: every tap is lit; without the
  // gradient those before the centre would not be.
  std::vector<float> texels;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) texels.push_back(0.1f + 0.1f * float(x));
  rhi::Texture map = mapOf(device(), 8, texels);
  const Query flat{.uvzBias = {3.7f / 8, 0.5f, 0.1f + 0.1f * 3.2f, 1e-5f}};
  Query plane = flat;
  plane.gradient = {0.8f, 0, 0, 0};
  const auto v = ask(device(), "filter_depth", map, {.kernel = 5}, {flat, plane});
  EXPECT_FLOAT_EQ(v[0][0], 2.0f / 5);
  EXPECT_EQ(v[1][0], 1);
}

GPU_TEST(ColourFilter, WorkedExampleOfOneTexel) {
  // Spec 04: M = (.5, .3, .9); a receiver at .6 sees (0, 0, 1), at .4 (1, 0, 1), at .95 nothing.
  std::vector<float> texels;
  for (int i = 0; i < 16; ++i) texels.insert(texels.end(), {0.5f, 0.3f, 0.9f, 1.0f});
  rhi::Texture map = mapOf(device(), 4, texels, rhi::Format::RGBA32Float);
  const auto v = ask(device(), "filter_colour", map, {},
                     {{.uvzBias = {0.5f, 0.5f, 0.6f, 0.01f}},
                      {.uvzBias = {0.5f, 0.5f, 0.4f, 0.01f}},
                      {.uvzBias = {0.5f, 0.5f, 0.95f, 0.01f}}});
  EXPECT_EQ(v[0], (Vec4{0, 0, 1, 1}));
  EXPECT_EQ(v[1], (Vec4{1, 0, 1, 1}));
  EXPECT_EQ(v[2], (Vec4{0, 0, 0, 1}));
}

GPU_TEST(ColourFilter, FarPlaneIsLitThoughOneMeansPassed) {
  // Depth 1 is both "passed" and the far plane: a receiver there is lit (spec 17). So is what lies
  // outside the map, at any depth.
  rhi::Texture map = mapOf(device(), 4, std::vector<float>(64, 1.0f), rhi::Format::RGBA32Float);
  rhi::Texture dark = mapOf(device(), 4, std::vector<float>(64, 0.0f), rhi::Format::RGBA32Float);
  EXPECT_EQ(
      ask(device(), "filter_colour", map, {.kernel = 3}, {{.uvzBias = {0.5f, 0.5f, 1, 0}}})[0],
      (Vec4{1, 1, 1, 1}));
  EXPECT_EQ(ask(device(), "filter_colour", dark, {}, {{.uvzBias = {1, 0.5f, 1, 0}}})[0],
            (Vec4{1, 1, 1, 1}));
}

GPU_TEST(ColourFilter, PartOfTheKernelOutsideCountsAsLit) {
  rhi::Texture map = mapOf(device(), 4, std::vector<float>(64, 0.0f), rhi::Format::RGBA32Float);
  const auto v =
      ask(device(), "filter_colour", map, {.kernel = 3},
          {{.uvzBias = {0.125f, 0.5f, 0.5f, 0}}, {.uvzBias = {0.875f, 0.875f, 0.5f, 0}}});
  EXPECT_FLOAT_EQ(v[0][1], 3.0f / 9);
  EXPECT_FLOAT_EQ(v[1][1], 5.0f / 9);
}
