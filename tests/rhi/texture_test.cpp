// Textures of every kind: arrays, volumes, mips, parts of them as views, odd sizes, copies.
#include <numeric>

#include "tests/rhi/resource_helpers.h"

using namespace sb::test;

namespace {

const rhi::SamplerDesc kNearest{.filter = rhi::Filter::Nearest, .maxLod = 16};

/// A 7x5 array of 3 layers with 3 mips; every texel of layer l, mip m is 10 l + m.
rhi::Texture makeArray(rhi::Device& device) {
  rhi::Texture array = device.createTexture(
      {.label = "array",
       .kind = rhi::TextureKind::Tex2DArray,
       .format = rhi::Format::R32Float,
       .width = 7,
       .height = 5,
       .layers = 3,
       .mips = 3,
       .use = rhi::TextureUse::Sampled | rhi::TextureUse::ColorTarget | kCopies});
  const uint32_t texels[] = {7 * 5, 3 * 2, 1};
  for (uint32_t layer = 0; layer < 3; ++layer)
    for (uint32_t mip = 0; mip < 3; ++mip)
      device.upload(array, {.mip = mip, .layer = layer},
                    bytesOf(std::vector<float>(texels[mip], float(layer * 10 + mip))));
  return array;
}

float texel(rhi::Device& device, rhi::TextureId texture, uint32_t mip, uint32_t layer) {
  return readTexels<float>(device, texture, {.mip = mip, .layer = layer})[0];
}

}  // namespace

GPU_TEST(Textures, ArrayLayersAndMipsAreApart) {
  rhi::Texture array = makeArray(device());
  std::vector<Vec4> at, expected;
  for (uint32_t layer = 0; layer < 3; ++layer)
    for (uint32_t mip = 0; mip < 3; ++mip) {
      at.push_back({0.5f, 0.5f, float(layer), float(mip)});
      expected.push_back({float(layer * 10 + mip), 0, 0, 1});
    }
  EXPECT_EQ(sampleAt(device(), "sample_2d_array", {.texture = array}, kNearest, at), expected);
}

GPU_TEST(Textures, ViewsStartAtTheirFirstMipAndLayer) {
  rhi::Texture array = makeArray(device());
  const rhi::TextureView view{.texture = array, .baseMip = 1, .mipCount = 2, .baseLayer = 1};
  const auto values = sampleAt(device(), "sample_2d_array", view, kNearest,
                               {{0.5f, 0.5f, 0, 0}, {0.5f, 0.5f, 1, 0}, {0.5f, 0.5f, 1, 1},
                                {0.5f, 0.5f, 9, 9}});
  EXPECT_EQ(values[0][0], 11);
  EXPECT_EQ(values[1][0], 21);
  EXPECT_EQ(values[2][0], 22);
  EXPECT_EQ(values[3][0], 22);  // beyond the view: clamped to its last layer and mip
}

GPU_TEST(Textures, ViewOfATexture2DKnowsItsSize) {
  rhi::Texture texture = device().createTexture({.label = "mips",
                                                 .format = rhi::Format::R8Unorm,
                                                 .width = 13,
                                                 .height = 4,
                                                 .mips = 4,
                                                 .use = rhi::TextureUse::Sampled | kCopies});
  const auto whole = sampleAt(device(), "sizes", {.texture = texture}, kNearest,
                              {{0, 0, 0, 0}, {0, 0, 0, 1}, {0, 0, 0, 3}});
  EXPECT_EQ(whole[0], (Vec4{13, 4, 4, 0}));
  EXPECT_EQ(whole[1], (Vec4{6, 2, 4, 0}));
  EXPECT_EQ(whole[2], (Vec4{1, 1, 4, 0}));
  const auto part = sampleAt(device(), "sizes", {.texture = texture, .baseMip = 1, .mipCount = 2},
                             kNearest, {{0, 0, 0, 0}});
  EXPECT_EQ(part[0], (Vec4{6, 2, 2, 0}));
}

GPU_TEST(Textures, VolumesFilterBetweenSlices) {
  rhi::Texture volume = device().createTexture({.label = "volume",
                                                .kind = rhi::TextureKind::Tex3D,
                                                .format = rhi::Format::R32Float,
                                                .width = 2,
                                                .height = 1,
                                                .depth = 4,
                                                .mips = 2,
                                                .use = rhi::TextureUse::Sampled | kCopies});
  for (uint32_t z = 0; z < 4; ++z)
    device().upload(volume, {.layer = z}, bytesOf(std::vector<float>{float(z), float(z) + 10}));
  for (uint32_t z = 0; z < 2; ++z)
    device().upload(volume, {.mip = 1, .layer = z}, bytesOf(std::vector<float>{float(z) + 50}));
  const auto values = sampleAt(
      device(), "sample_3d", {.texture = volume},
      {.addressU = rhi::AddressMode::ClampToEdge, .addressW = rhi::AddressMode::ClampToEdge,
       .maxLod = 4},
      {{0.25f, 0.5f, 0.125f, 0}, {0.75f, 0.5f, 0.625f, 0}, {0.5f, 0.5f, 0.5f, 0},
       {0.5f, 0.5f, 0.75f, 1}});
  EXPECT_NEAR(values[0][0], 0, 1e-4);
  EXPECT_NEAR(values[1][0], 12, 1e-4);
  EXPECT_NEAR(values[2][0], 6.5, 1e-2);
  EXPECT_NEAR(values[3][0], 51, 1e-4);
  EXPECT_EQ(readTexels<float>(device(), volume, {.layer = 3, .x = 1, .width = 1}),
            std::vector<float>{13});
}

GPU_TEST(Textures, PassesClearExactlyTheirMipAndLayers) {
  rhi::Texture array = makeArray(device());
  frame(device(), [&](rhi::CommandList& list) {
    const rhi::ColorAttachment one{
        .view = {.texture = array, .baseMip = 1, .mipCount = 1, .baseLayer = 2, .layerCount = 1},
        .clear = {-1, 0, 0, 0}};
    list.beginPass({.label = "one layer", .colors = {&one, 1}}).end();
    const rhi::ColorAttachment two{
        .view = {.texture = array, .baseMip = 0, .mipCount = 1, .baseLayer = 1, .layerCount = 2},
        .clear = {-2, 0, 0, 0}};
    list.beginPass({.label = "two layers", .colors = {&two, 1}}).end();
  });
  const float expected[3][3] = {{0, 1, 2}, {-2, 11, 12}, {-2, -1, 22}};
  for (uint32_t layer = 0; layer < 3; ++layer)
    for (uint32_t mip = 0; mip < 3; ++mip)
      EXPECT_EQ(texel(device(), array, mip, layer), expected[layer][mip]) << layer << ' ' << mip;
}

GPU_TEST(Textures, UploadsAndReadsOfRegions) {
  rhi::Texture texture =
      texture2D(device(), rhi::Format::R8Unorm, 5, 3, rhi::TextureUse::Sampled);
  std::vector<uint8_t> expected(15);
  std::iota(expected.begin(), expected.end(), uint8_t(1));
  device().upload(texture, {}, bytesOf(expected));
  device().upload(texture, {.x = 1, .y = 1, .width = 3, .height = 2},
                  bytesOf(std::vector<uint8_t>{101, 102, 103, 104, 105, 106}));
  for (uint32_t i = 0; i < 6; ++i) expected[(1 + i / 3) * 5 + 1 + i % 3] = uint8_t(101 + i);
  EXPECT_EQ(readTexels<uint8_t>(device(), texture), expected);
  EXPECT_EQ(readTexels<uint8_t>(device(), texture, {.x = 3, .y = 1, .width = 2, .height = 2}),
            (std::vector<uint8_t>{103, expected[9], 106, expected[14]}));
}

GPU_TEST(Textures, OneByOne) {
  rhi::Texture texture = texture2D(device(), rhi::Format::RGBA8Unorm, 1, 1,
                                   rhi::TextureUse::Sampled | rhi::TextureUse::ColorTarget);
  frame(device(), [&](rhi::CommandList& list) {
    const rhi::ColorAttachment color{.view = {.texture = texture}, .clear = {1, 0, 1, 0}};
    list.beginPass({.label = "clear", .colors = {&color, 1}}).end();
  });
  const auto values = sampleAt(device(), "sample_2d", {.texture = texture}, {},
                               {{0.1f, 0.9f, 0, 0}, {-3.5f, 7.25f, 0, 0}});
  EXPECT_EQ(values[0], (Vec4{1, 0, 1, 0}));
  EXPECT_EQ(values[1], (Vec4{1, 0, 1, 0}));
}

GPU_TEST(Textures, CopiesTakeAllMipsAndLayersOfTheirViews) {
  rhi::Texture source = makeArray(device()), target = makeArray(device());
  frame(device(), [&](rhi::CommandList& list) {
    list.copy({.texture = source, .baseMip = 1, .mipCount = 2, .baseLayer = 0, .layerCount = 2},
              {.texture = target, .baseMip = 1, .mipCount = 2, .baseLayer = 1, .layerCount = 2});
  });
  const float expected[3][3] = {{0, 1, 2}, {10, 1, 2}, {20, 11, 12}};
  for (uint32_t layer = 0; layer < 3; ++layer)
    for (uint32_t mip = 0; mip < 3; ++mip)
      EXPECT_EQ(texel(device(), target, mip, layer), expected[layer][mip]) << layer << ' ' << mip;
}

GPU_TEST(Textures, FormatCapsAdmitWhatBothApisRequire) {
  using enum rhi::Format;
  for (rhi::Format format : {R8Unorm, RGBA8Unorm, RGBA8Srgb, RGBA16Float}) {
    const rhi::FormatCaps caps = device().formatCaps(format);
    EXPECT_TRUE(caps.sampled && caps.linearFilter && caps.colorTarget && caps.blend)
        << rhi::formatInfo(format).name;
  }
  for (rhi::Format format : {R32Uint, R32Sint})
    EXPECT_TRUE(device().formatCaps(format).storageAtomic) << rhi::formatInfo(format).name;
  EXPECT_TRUE(device().formatCaps(D32Float).depthTarget);
  EXPECT_FALSE(device().formatCaps(D32Float).colorTarget);
  EXPECT_FALSE(device().formatCaps(RGBA8Unorm).depthTarget);
  EXPECT_FALSE(device().formatCaps(R32Uint).linearFilter);
}
