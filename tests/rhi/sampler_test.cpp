// Samplers: wrap modes, borders, filter weights, mips, gather.
#include <cmath>

#include "tests/rhi/resource_helpers.h"

using namespace sb::test;

namespace {

/// Four texels in a row: 1, 2, 3, 4.
rhi::Texture makeRow(rhi::Device& device) {
  rhi::Texture row = texture2D(device, rhi::Format::R32Float, 4, 1, rhi::TextureUse::Sampled);
  device.upload(row, {}, bytesOf(std::vector<float>{1, 2, 3, 4}));
  return row;
}

/// Value of texel `i` under an address mode.
float wrapped(rhi::AddressMode mode, int i, float border) {
  const int repeat = ((i % 4) + 4) % 4, mirror = ((i % 8) + 8) % 8;
  switch (mode) {
    case rhi::AddressMode::Repeat: return float(repeat + 1);
    case rhi::AddressMode::MirroredRepeat: return float((mirror < 4 ? mirror : 7 - mirror) + 1);
    case rhi::AddressMode::ClampToEdge: return float(std::min(std::max(i, 0), 3) + 1);
    case rhi::AddressMode::ClampToBorder: return i < 0 || i > 3 ? border : float(i + 1);
  }
  return 0;
}

constexpr rhi::AddressMode kModes[] = {
    rhi::AddressMode::Repeat, rhi::AddressMode::MirroredRepeat, rhi::AddressMode::ClampToEdge,
    rhi::AddressMode::ClampToBorder};

}  // namespace

GPU_TEST(Samplers, NearestUnderEveryWrapMode) {
  rhi::Texture row = makeRow(device());
  std::vector<Vec4> at;
  for (int i = -9; i < 13; ++i) at.push_back({(float(i) + 0.5f) / 4, 0.5f, 0, 0});
  for (rhi::AddressMode mode : kModes)
    for (rhi::BorderColor border :
         {rhi::BorderColor::TransparentBlack, rhi::BorderColor::OpaqueWhite}) {
      const auto values =
          sampleAt(device(), "sample_2d", {.texture = row},
                   {.filter = rhi::Filter::Nearest, .addressU = mode, .addressV = mode,
                    .border = border},
                   at);
      const float edge = border == rhi::BorderColor::OpaqueWhite ? 1.0f : 0.0f;
      for (int i = -9; i < 13; ++i)
        EXPECT_EQ(values[size_t(i + 9)][0], wrapped(mode, i, edge))
            << "mode " << int(mode) << " texel " << i;
    }
}

GPU_TEST(Samplers, LinearWeightsUnderEveryWrapMode) {
  rhi::Texture row = makeRow(device());
  // Fractions that eight bits of weight represent exactly.
  const float fractions[] = {0, 0.25f, 0.5f, 0.75f};
  std::vector<Vec4> at;
  for (int i = -5; i < 9; ++i)
    for (float f : fractions) at.push_back({(float(i) + 0.5f + f) / 4, 0.5f, 0, 0});
  for (rhi::AddressMode mode : kModes) {
    const auto values = sampleAt(device(), "sample_2d", {.texture = row},
                                 {.addressU = mode, .addressV = rhi::AddressMode::ClampToEdge,
                                  .border = rhi::BorderColor::OpaqueWhite},
                                 at);
    size_t k = 0;
    for (int i = -5; i < 9; ++i)
      for (float f : fractions) {
        const float expected = wrapped(mode, i, 1) * (1 - f) + wrapped(mode, i + 1, 1) * f;
        EXPECT_NEAR(values[k++][0], expected, 1e-4) << "mode " << int(mode) << " at " << i << "+" << f;
      }
  }
}

GPU_TEST(Samplers, BilinearBlendsFourTexels) {
  rhi::Texture quad = texture2D(device(), rhi::Format::RG32Float, 2, 2, rhi::TextureUse::Sampled);
  device().upload(quad, {}, bytesOf(std::vector<float>{0, 5, 16, 5, 32, 5, 64, 5}));
  const auto value = sampleAt(device(), "sample_2d", {.texture = quad}, {},
                              {{0.25f + 0.125f, 0.25f + 0.375f, 0, 0}})[0];
  const float fx = 0.25f, fy = 0.75f;
  expectNear(value, {(0 * (1 - fx) + 16 * fx) * (1 - fy) + (32 * (1 - fx) + 64 * fx) * fy, 5, 0, 1},
             1e-3f, "bilinear");
}

GPU_TEST(Samplers, BorderColorFillsAllChannels) {
  rhi::Texture texel = texture2D(device(), rhi::Format::RGBA8Unorm, 1, 1, rhi::TextureUse::Sampled);
  device().upload(texel, {}, bytesOf(std::vector<uint8_t>{128, 128, 128, 128}));
  for (rhi::BorderColor border :
       {rhi::BorderColor::TransparentBlack, rhi::BorderColor::OpaqueWhite}) {
    const auto value = sampleAt(device(), "sample_2d", {.texture = texel},
                                {.addressU = rhi::AddressMode::ClampToBorder, .border = border},
                                {{5, 0.5f, 0, 0}})[0];
    const float v = border == rhi::BorderColor::OpaqueWhite ? 1.0f : 0.0f;
    EXPECT_EQ(value, (Vec4{v, v, v, v}));
  }
}

GPU_TEST(Samplers, MipFilterAndMaxLod) {
  rhi::Texture mips = device().createTexture({.label = "mips",
                                              .format = rhi::Format::R32Float,
                                              .width = 4,
                                              .height = 4,
                                              .mips = 3,
                                              .use = rhi::TextureUse::Sampled | kCopies});
  for (uint32_t mip = 0; mip < 3; ++mip)
    device().upload(mips, {.mip = mip},
                    bytesOf(std::vector<float>((4 >> mip) * (4 >> mip), float(mip) * 8)));
  const std::vector<Vec4> at = {{0.5f, 0.5f, 0, 0}, {0.5f, 0.5f, 0, 0.25f}, {0.5f, 0.5f, 0, 0.75f},
                                {0.5f, 0.5f, 0, 1.5f}, {0.5f, 0.5f, 0, 9}};
  auto lods = [&](rhi::Filter mipFilter, float maxLod) {
    std::vector<float> out;
    for (const Vec4& v : sampleAt(device(), "sample_2d", {.texture = mips},
                                  {.mipFilter = mipFilter, .maxLod = maxLod}, at))
      out.push_back(v[0]);
    return out;
  };
  EXPECT_EQ(lods(rhi::Filter::Linear, 8), (std::vector<float>{0, 2, 6, 12, 16}));
  EXPECT_EQ(lods(rhi::Filter::Linear, 1), (std::vector<float>{0, 2, 6, 8, 8}));
  const auto nearest = lods(rhi::Filter::Nearest, 8);
  EXPECT_EQ(nearest[1], 0);
  EXPECT_EQ(nearest[2], 8);
  EXPECT_EQ(nearest[4], 16);
  EXPECT_EQ(lods(rhi::Filter::Nearest, 0), (std::vector<float>{0, 0, 0, 0, 0}));
}

GPU_TEST(Samplers, ImplicitLevelOfDetailFollowsTheFootprint) {
  rhi::Texture mips = device().createTexture({.label = "mips",
                                              .format = rhi::Format::R32Float,
                                              .width = 16,
                                              .height = 16,
                                              .mips = 5,
                                              .use = rhi::TextureUse::Sampled | kCopies});
  for (uint32_t mip = 0; mip < 5; ++mip)
    device().upload(mips, {.mip = mip},
                    bytesOf(std::vector<float>((16 >> mip) * (16 >> mip), float(mip))));
  rhi::Sampler sampler = device().createSampler({.label = "mips", .maxLod = 8});
  rhi::Pipeline pipeline =
      device().createPipeline(graphics("fullscreen", "sample_implicit", {rhi::Format::R32Float}));
  for (uint32_t size : {16u, 8u, 4u}) {
    rhi::Texture target =
        texture2D(device(), rhi::Format::R32Float, size, size, rhi::TextureUse::ColorTarget);
    frame(device(), [&](rhi::CommandList& list) {
      const rhi::ColorAttachment color{.view = {.texture = target}};
      const rhi::ResourceUse reads[] = {rhi::use(mips.id(), rhi::Access::Sampled)};
      auto pass = list.beginPass({.label = "minify", .colors = {&color, 1}, .reads = reads});
      const rhi::Binding bindings[] = {rhi::textureAt(0, mips.id(), sampler)};
      list.draw({.pipeline = pipeline, .bindings = bindings}, {.vertexCount = 3});
    });
    const float expected = std::log2(16.0f / float(size));
    EXPECT_EQ(readTexels<float>(device(), target), std::vector<float>(size * size, expected));
  }
}

GPU_TEST(Samplers, GatherOrder) {
  rhi::Texture quad = texture2D(device(), rhi::Format::R32Float, 3, 3, rhi::TextureUse::Sampled);
  device().upload(quad, {}, bytesOf(std::vector<float>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
  const auto values =
      sampleAt(device(), "gather", {.texture = quad}, {.filter = rhi::Filter::Nearest},
               {{1.0f / 3, 1.0f / 3, 0, 0}, {2.0f / 3, 1.0f / 3, 0, 0}});
  EXPECT_EQ(values[0], (Vec4{3, 4, 1, 0}));  // counter-clockwise from the texel of greater v
  EXPECT_EQ(values[1], (Vec4{4, 5, 2, 1}));
}
