// Comparison samplers: what shadow maps are read through.
#include "tests/rhi/resource_helpers.h"

using namespace sb::test;

namespace {

rhi::Texture depthQuad(rhi::Device& device, std::vector<float> texels) {
  rhi::Texture quad = texture2D(device, rhi::Format::D32Float, 2, 2,
                                rhi::TextureUse::Sampled | rhi::TextureUse::DepthTarget);
  device.upload(quad, {}, bytesOf(texels));
  return quad;
}

}  // namespace

GPU_TEST(CompareSamplers, PercentageCloserFilteringBlendsComparisons) {
  // Columns 0.2 and 0.8; a receiver at 0.49 is lit by the right column alone: fx = 0.75 of it.
  rhi::Texture map = depthQuad(device(), {0.2f, 0.8f, 0.2f, 0.8f});
  const auto value = sampleAt(device(), "sample_shadow", {.texture = map},
                              {.compare = rhi::CompareOp::LessOrEqual},
                              {{0.25f + 0.375f, 0.5f, 0, 0.49f}})[0];
  EXPECT_NEAR(value[0], 0.75f, 1.0f / 256);
  // Rows 0.2 and 0.8.
  rhi::Texture rows = depthQuad(device(), {0.2f, 0.2f, 0.8f, 0.8f});
  EXPECT_NEAR(sampleAt(device(), "sample_shadow", {.texture = rows},
                       {.compare = rhi::CompareOp::LessOrEqual},
                       {{0.5f, 0.25f + 0.125f, 0, 0.49f}})[0][0],
              0.25f, 1.0f / 256);
}

GPU_TEST(CompareSamplers, EveryComparison) {
  rhi::Texture map = depthQuad(device(), {0.5f, 0.5f, 0.5f, 0.5f});
  const std::vector<Vec4> at = {
      {0.5f, 0.5f, 0, 0.25f}, {0.5f, 0.5f, 0, 0.5f}, {0.5f, 0.5f, 0, 0.75f}};
  // reference OP texel, for references below, at and above the texel
  const int expected[8][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                              {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  for (int op = 0; op < 8; ++op) {
    const auto values =
        sampleAt(device(), "sample_shadow", {.texture = map},
                 {.filter = rhi::Filter::Nearest, .compare = rhi::CompareOp(op)}, at);
    for (size_t i = 0; i < 3; ++i)
      EXPECT_EQ(values[i][0], float(expected[op][i])) << "op " << op << " reference " << i;
  }
}

GPU_TEST(CompareSamplers, WhiteBorderReadsAsLit) {
  rhi::Texture map = depthQuad(device(), {0, 0, 0, 0});
  const auto values = sampleAt(device(), "sample_shadow", {.texture = map},
                               {.addressU = rhi::AddressMode::ClampToBorder,
                                .addressV = rhi::AddressMode::ClampToBorder,
                                .border = rhi::BorderColor::OpaqueWhite,
                                .compare = rhi::CompareOp::LessOrEqual},
                               {{0.5f, 0.5f, 0, 0.9f}, {2, 0.5f, 0, 0.9f}, {1, 0.5f, 0, 0.9f}});
  EXPECT_EQ(values[0][0], 0);
  EXPECT_EQ(values[1][0], 1);
  EXPECT_NEAR(values[2][0], 0.5f, 1.0f / 256);
}

GPU_TEST(CompareSamplers, GatherComparesFourTexels) {
  rhi::Texture map = depthQuad(device(), {0.1f, 0.9f, 0.6f, 0.4f});
  const auto value = sampleAt(device(), "gather_shadow", {.texture = map},
                              {.compare = rhi::CompareOp::LessOrEqual}, {{0.5f, 0.5f, 0, 0.5f}})[0];
  EXPECT_EQ(value, (Vec4{1, 0, 1, 0}));
}
