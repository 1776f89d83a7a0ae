// What one pass writes the next one sees, by every path between passes; and no pass overtakes the
// reads of an earlier one.
#include <numeric>

#include "tests/rhi/resource_helpers.h"

using namespace sb::test;

namespace {
constexpr uint32_t kSize = 61;
}

GPU_TEST(Visibility, ChainOfDispatches) {
  constexpr uint32_t kCount = 4096, kPasses = 20;
  std::vector<uint32_t> expected(kCount);
  std::iota(expected.begin(), expected.end(), 0u);
  rhi::Buffer a = bufferOf(device(), expected), b = bufferOf(device(), expected);
  rhi::Pipeline pipeline = computePipeline(device(), "rotate");
  frame(device(), [&](rhi::CommandList& list) {
    for (uint32_t i = 0; i < kPasses; ++i) {
      rhi::BufferId from = i % 2 ? b : a, to = i % 2 ? a : b;
      computePass(list, pipeline, {rhi::storageAt(0, from), rhi::storageAt(1, to)},
                  {rhi::use(from, rhi::Access::StorageRead)},
                  {rhi::use(to, rhi::Access::StorageWrite)}, {kCount / 64, 1, 1});
    }
  });
  for (uint32_t i = 0; i < kPasses; ++i) {
    std::vector<uint32_t> next(kCount);
    for (uint32_t k = 0; k < kCount; ++k) next[k] = expected[(k + 1) % kCount] * 2 + 1;
    expected = next;
  }
  EXPECT_EQ(readAll<uint32_t>(device(), a), expected);
}

GPU_TEST(Visibility, AttachmentIsSampledByTheNextPass) {
  rhi::Texture first = texture2D(device(), rhi::Format::R32Uint, kSize, kSize,
                                 rhi::TextureUse::ColorTarget | rhi::TextureUse::Sampled);
  rhi::Texture second = texture2D(device(), rhi::Format::R32Uint, kSize, kSize,
                                  rhi::TextureUse::ColorTarget | rhi::TextureUse::Sampled);
  rhi::Sampler sampler = device().createSampler({.label = "nearest", .filter = rhi::Filter::Nearest});
  rhi::Pipeline draw =
      device().createPipeline(graphics("fullscreen", "coordinates", {rhi::Format::R32Uint}));
  rhi::Pipeline fetch =
      device().createPipeline(graphics("fullscreen", "fetch_flipped", {rhi::Format::R32Uint}));
  frame(device(), [&](rhi::CommandList& list) {
    {
      const rhi::ColorAttachment color{.view = {.texture = first}};
      auto pass = list.beginPass({.label = "first", .colors = {&color, 1}});
      list.draw({.pipeline = draw}, {.vertexCount = 3});
    }
    // To and fro: each texture is attachment, then sampled, then attachment again.
    for (int i = 0; i < 4; ++i) {
      rhi::TextureId from = i % 2 ? second : first, to = i % 2 ? first : second;
      const rhi::ColorAttachment color{.view = {.texture = to}, .load = rhi::LoadOp::DontCare};
      const rhi::ResourceUse reads[] = {rhi::use(from, rhi::Access::Sampled)};
      auto pass = list.beginPass({.label = "flip", .colors = {&color, 1}, .reads = reads});
      const rhi::Binding bindings[] = {rhi::textureAt(0, from, sampler)};
      list.draw({.pipeline = fetch, .bindings = bindings}, {.vertexCount = 3});
    }
  });
  const auto texels = readTexels<uint32_t>(device(), first);
  for (uint32_t y = 0; y < kSize; ++y)
    for (uint32_t x = 0; x < kSize; ++x)
      ASSERT_EQ(texels[y * kSize + x], y * 1000 + x + 4) << x << ", " << y;
}

GPU_TEST(Visibility, ImageStoreIsFetchedByTheNextPass) {
  rhi::Texture image = texture2D(device(), rhi::Format::R32Uint, kSize, kSize,
                                 rhi::TextureUse::Storage | rhi::TextureUse::Sampled);
  rhi::Texture target =
      texture2D(device(), rhi::Format::R32Uint, kSize, kSize, rhi::TextureUse::ColorTarget);
  rhi::Sampler sampler = device().createSampler({.label = "nearest", .filter = rhi::Filter::Nearest});
  rhi::Pipeline store = computePipeline(device(), "store_image");
  rhi::Pipeline fetch =
      device().createPipeline(graphics("fullscreen", "fetch_flipped", {rhi::Format::R32Uint}));
  frame(device(), [&](rhi::CommandList& list) {
    computePass(list, store, {rhi::imageAt(0, {.texture = image})}, {},
                {rhi::use(image.id(), rhi::Access::StorageWrite)}, {kSize, kSize, 1});
    const rhi::ColorAttachment color{.view = {.texture = target}};
    const rhi::ResourceUse reads[] = {rhi::use(image.id(), rhi::Access::Sampled)};
    auto pass = list.beginPass({.label = "fetch", .colors = {&color, 1}, .reads = reads});
    const rhi::Binding bindings[] = {rhi::textureAt(0, image.id(), sampler)};
    list.draw({.pipeline = fetch, .bindings = bindings}, {.vertexCount = 3});
  });
  const auto texels = readTexels<uint32_t>(device(), target);
  for (uint32_t y = 0; y < kSize; ++y)
    for (uint32_t x = 0; x < kSize; ++x)
      ASSERT_EQ(texels[y * kSize + x], (kSize - 1 - y) * 1000 + (kSize - 1 - x) + 1);
}

GPU_TEST(Visibility, StoresDoNotOvertakeEarlierReads) {
  std::vector<uint32_t> before(kSize * kSize);
  std::iota(before.begin(), before.end(), 0u);
  rhi::Buffer values = bufferOf(device(), before);
  rhi::Buffer other = bufferOf(device(), std::vector<uint32_t>(kSize * kSize, 77));
  rhi::Buffer size = bufferOf(device(), std::vector<uint32_t>{kSize, 0, 0, 0});
  rhi::Texture target =
      texture2D(device(), rhi::Format::R32Uint, kSize, kSize, rhi::TextureUse::ColorTarget);
  rhi::Pipeline show =
      device().createPipeline(graphics("fullscreen", "show_words", {rhi::Format::R32Uint}));
  rhi::Pipeline copy = computePipeline(device(), "store_words");
  frame(device(), [&](rhi::CommandList& list) {
    {
      const rhi::ColorAttachment color{.view = {.texture = target}};
      const rhi::ResourceUse reads[] = {rhi::use(values, rhi::Access::StorageRead)};
      auto pass = list.beginPass({.label = "show", .colors = {&color, 1}, .reads = reads});
      const rhi::Binding bindings[] = {rhi::uniformAt(0, size), rhi::storageAt(0, values)};
      list.draw({.pipeline = show, .bindings = bindings}, {.vertexCount = 3});
    }
    computePass(list, copy, {rhi::storageAt(0, other), rhi::storageAt(1, values)},
                {rhi::use(other, rhi::Access::StorageRead)},
                {rhi::use(values, rhi::Access::StorageWrite)}, {kSize * kSize, 1, 1});
  });
  EXPECT_EQ(readTexels<uint32_t>(device(), target), before);
  EXPECT_EQ(readAll<uint32_t>(device(), values), std::vector<uint32_t>(kSize * kSize, 77));
}

GPU_TEST(Visibility, StoresFeedVerticesIndicesAndUniforms) {
  // Made by a dispatch: the vertices of cells.vert, their indices, and its uniform.
  rhi::Buffer sources[3] = {bufferOf(device(), std::vector<uint32_t>{2, 2, 2, 2, 2, 2}),
                            bufferOf(device(), std::vector<uint32_t>{0, 1, 2, 3, 4, 5}),
                            bufferOf(device(), std::vector<uint32_t>{4, 0, 0, 0})};
  rhi::Buffer made[3];
  for (size_t i = 0; i < 3; ++i)
    made[i] = bufferOf(device(),
                       std::vector<uint32_t>(device().bufferDesc(sources[i]).size / 4, 0));
  rhi::Texture target =
      texture2D(device(), rhi::Format::R32Uint, 4, 1, rhi::TextureUse::ColorTarget);
  rhi::Pipeline copy = computePipeline(device(), "store_words");
  auto desc = graphics("cells", "cells", {rhi::Format::R32Uint});
  desc.vertexBuffers = {{.stride = 4}};
  desc.attributes = {{.location = 0, .format = rhi::VertexFormat::Uint}};
  rhi::Pipeline cells = device().createPipeline(desc);
  frame(device(), [&](rhi::CommandList& list) {
    for (size_t i = 0; i < 3; ++i)
      computePass(list, copy, {rhi::storageAt(0, sources[i]), rhi::storageAt(1, made[i])},
                  {rhi::use(sources[i], rhi::Access::StorageRead)},
                  {rhi::use(made[i], rhi::Access::StorageWrite)},
                  {uint32_t(device().bufferDesc(made[i]).size / 4), 1, 1});
    const rhi::ColorAttachment color{.view = {.texture = target}};
    const rhi::ResourceUse reads[] = {rhi::use(made[0], rhi::Access::Vertex),
                                      rhi::use(made[1], rhi::Access::Index),
                                      rhi::use(made[2], rhi::Access::Uniform)};
    auto pass = list.beginPass({.label = "cells", .colors = {&color, 1}, .reads = reads});
    const rhi::Binding bindings[] = {rhi::uniformAt(0, made[2])};
    const rhi::VertexBufferBinding vertices[] = {{made[0]}};
    list.drawIndexed({.pipeline = cells,
                      .bindings = bindings,
                      .vertexBuffers = vertices,
                      .indexBuffer = made[1]},
                     {.indexCount = 6});
  });
  EXPECT_EQ(readTexels<uint32_t>(device(), target), (std::vector<uint32_t>{0, 0, 3, 0}));
}
