// Storage buffers and images in fragment shaders: atomics, 128-bit masks, stores.
#include <numeric>

#include "tests/rhi/resource_helpers.h"

using namespace sb::test;

GPU_TEST(Storage, FragmentAtomicsCountExactlyTheCoveredPixels) {
  if (!device().supports(rhi::Feature::FragmentStoresAndAtomics)) GTEST_SKIP();
  constexpr uint32_t kSize = 37;  // odd, so that quads and SIMD groups have helper lanes
  rhi::Texture perPixel = texture2D(device(), rhi::Format::R32Uint, kSize, kSize,
                                    rhi::TextureUse::Storage | rhi::TextureUse::ColorTarget);
  device().upload(perPixel, {}, bytesOf(std::vector<uint32_t>(kSize * kSize, 0)));
  rhi::Buffer totals = bufferOf(device(), std::vector<uint32_t>{0, 0, 0});
  rhi::Pipeline pipeline = device().createPipeline(graphics("fullscreen", "atomics"));
  frame(device(), [&](rhi::CommandList& list) {
    const rhi::ResourceUse writes[] = {rhi::use(totals, rhi::Access::StorageWrite),
                                       rhi::use(perPixel.id(), rhi::Access::StorageWrite)};
    auto pass =
        list.beginPass({.label = "count", .writes = writes, .extent = {kSize, kSize}});
    const rhi::Binding bindings[] = {rhi::storageAt(0, totals),
                                     rhi::imageAt(0, {.texture = perPixel})};
    list.draw({.pipeline = pipeline, .bindings = bindings, .scissor = rhi::Rect{3, 5, 30, 29}},
              {.vertexCount = 3, .instanceCount = 3});
  });
  const auto counts = readAll<uint32_t>(device(), totals);
  EXPECT_EQ(counts[0], 3u * 30 * 29);
  EXPECT_EQ(counts[1], 33u * 1000 + 32);
  uint32_t parity = 0;
  const auto texels = readTexels<uint32_t>(device(), perPixel);
  for (uint32_t y = 0; y < kSize; ++y)
    for (uint32_t x = 0; x < kSize; ++x) {
      const bool inside = x >= 3 && x < 33 && y >= 5 && y < 34;
      EXPECT_EQ(texels[y * kSize + x], inside ? 6u : 0u) << x << ", " << y;
      if (inside) parity ^= (y * 1000 + x) * 2654435761u;
    }
  EXPECT_EQ(counts[2], parity);  // three times is once
}

GPU_TEST(Storage, OrOf128BitsByImagesAndByBuffers) {
  if (!device().supports(rhi::Feature::FragmentStoresAndAtomics)) GTEST_SKIP();
  constexpr uint32_t kWidth = 13, kHeight = 7;
  rhi::Texture layers = device().createTexture({.label = "masks",
                                                .kind = rhi::TextureKind::Tex2DArray,
                                                .format = rhi::Format::R32Uint,
                                                .width = kWidth,
                                                .height = kHeight,
                                                .layers = 4,
                                                .use = rhi::TextureUse::Storage | kCopies});
  for (uint32_t layer = 0; layer < 4; ++layer)
    device().upload(layers, {.layer = layer},
                    bytesOf(std::vector<uint32_t>(kWidth * kHeight, 0)));
  rhi::Buffer words =
      bufferOf(device(), std::vector<uint32_t>(size_t(kWidth) * kHeight * 4, 0));
  rhi::Buffer size = bufferOf(device(), std::vector<uint32_t>{kWidth, 0, 0, 0});
  rhi::Pipeline pipeline = device().createPipeline(graphics("fullscreen", "or128"));
  frame(device(), [&](rhi::CommandList& list) {
    const rhi::ResourceUse writes[] = {rhi::use(words, rhi::Access::StorageWrite),
                                       rhi::use(layers.id(), rhi::Access::StorageWrite)};
    auto pass = list.beginPass({.label = "or", .writes = writes, .extent = {kWidth, kHeight}});
    const rhi::Binding bindings[] = {rhi::uniformAt(0, size), rhi::storageAt(0, words),
                                     rhi::imageAt(0, {.texture = layers})};
    list.draw({.pipeline = pipeline, .bindings = bindings},
              {.vertexCount = 3, .instanceCount = 128});
  });
  const auto buffer = readAll<uint32_t>(device(), words);
  for (uint32_t layer = 0; layer < 4; ++layer) {
    const auto image = readTexels<uint32_t>(device(), layers, {.layer = layer});
    for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
      uint32_t expected = 0;
      for (uint32_t bit = 0; bit < 32; ++bit)
        if ((i % kWidth + layer * 32 + bit) % 3 != 0) expected |= 1u << bit;
      ASSERT_EQ(image[i], expected) << "texel " << i << " layer " << layer;
      ASSERT_EQ(buffer[i * 4 + layer], expected) << "texel " << i << " word " << layer;
    }
  }
}

GPU_TEST(Storage, ImagesOfArraysAndVolumes) {
  rhi::Texture array = device().createTexture({.label = "array",
                                               .kind = rhi::TextureKind::Tex2DArray,
                                               .format = rhi::Format::RGBA32Float,
                                               .width = 6,
                                               .height = 6,
                                               .layers = 5,
                                               .mips = 2,
                                               .use = rhi::TextureUse::Storage | kCopies});
  for (uint32_t layer = 0; layer < 5; ++layer)
    device().upload(array, {.mip = 1, .layer = layer},
                    bytesOf(std::vector<Vec4>(9, Vec4{100, 200, 300, 400})));
  rhi::Texture volume = device().createTexture({.label = "volume",
                                                .kind = rhi::TextureKind::Tex3D,
                                                .format = rhi::Format::R32Float,
                                                .width = 3,
                                                .height = 2,
                                                .depth = 4,
                                                .use = rhi::TextureUse::Storage | kCopies});
  rhi::Pipeline addArray = computePipeline(device(), "store_image_array");
  rhi::Pipeline fillVolume = computePipeline(device(), "store_image_3d");
  // Mip 1, layers 2 and 3 only.
  const rhi::TextureView part{
      .texture = array, .baseMip = 1, .mipCount = 1, .baseLayer = 2, .layerCount = 2};
  frame(device(), [&](rhi::CommandList& list) {
    computePass(list, addArray, {rhi::imageAt(0, part)}, {},
                {rhi::use(part, rhi::Access::StorageWrite)}, {3, 3, 2});
    computePass(list, fillVolume, {rhi::imageAt(0, {.texture = volume})}, {},
                {rhi::use(volume.id(), rhi::Access::StorageWrite)}, {3, 2, 4});
  });
  for (uint32_t layer = 0; layer < 5; ++layer) {
    const auto texel = readTexels<Vec4>(device(), array, {.mip = 1, .layer = layer})[5];
    const bool inside = layer == 2 || layer == 3;
    EXPECT_EQ(texel, (inside ? Vec4{102, 201, 300 + float(layer - 2), 401}
                             : Vec4{100, 200, 300, 400}))
        << layer;
  }
  for (uint32_t z = 0; z < 4; ++z) {
    const auto slice = readTexels<float>(device(), volume, {.layer = z});
    EXPECT_EQ(slice, (std::vector<float>{z * 100.f, z * 100.f + 1, z * 100.f + 2, z * 100.f + 10,
                                         z * 100.f + 11, z * 100.f + 12}));
  }
}
