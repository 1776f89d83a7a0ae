// Indirect draws: arguments at an offset, several draws with and without a stride, indexed and not.
#include "tests/rhi/resource_helpers.h"

using namespace sb::test;

namespace {

using Row = std::vector<uint32_t>;

Row drawCells(rhi::Device& device, const std::vector<uint32_t>& args, uint64_t offset,
              uint32_t draws, uint32_t stride, bool indexed) {
  rhi::Texture target =
      texture2D(device, rhi::Format::R32Uint, 8, 1, rhi::TextureUse::ColorTarget);
  rhi::Buffer size = bufferOf(device, Row{8, 0, 0, 0});
  Row cells, indices;
  for (uint32_t i = 0; i < 48; ++i) {
    cells.push_back(i / 6);
    indices.push_back(i);
  }
  rhi::Buffer vertices = bufferOf(device, cells), indexBuffer = bufferOf(device, indices);
  rhi::Buffer arguments = bufferOf(device, args);
  auto desc = graphics("cells", "cells", {rhi::Format::R32Uint});
  desc.vertexBuffers = {{.stride = 4}};
  desc.attributes = {{.location = 0, .format = rhi::VertexFormat::Uint}};
  rhi::Pipeline pipeline = device.createPipeline(desc);
  frame(device, [&](rhi::CommandList& list) {
    const rhi::ColorAttachment color{.view = {.texture = target}};
    auto pass = list.beginPass({.label = "indirect", .colors = {&color, 1}});
    const rhi::Binding bindings[] = {rhi::uniformAt(0, size)};
    const rhi::VertexBufferBinding buffers[] = {{vertices}};
    const rhi::DrawState state{.pipeline = pipeline,
                               .bindings = bindings,
                               .vertexBuffers = buffers,
                               .indexBuffer = indexed ? indexBuffer.id() : rhi::BufferId{}};
    const rhi::IndirectArgs indirect{
        .buffer = arguments, .offset = offset, .drawCount = draws, .stride = stride};
    if (indexed)
      list.drawIndexedIndirect(state, indirect);
    else
      list.drawIndirect(state, indirect);
  });
  return readTexels<uint32_t>(device, target);
}

}  // namespace

GPU_TEST(Indirect, OneDrawAtAnOffset) {
  EXPECT_EQ(drawCells(device(), {99, 99, 6, 2, 12, 0}, 8, 1, 0, false),
            (Row{0, 0, 3, 4, 0, 0, 0, 0}));
}

GPU_TEST(Indirect, OneIndexedDraw) {
  // count, instances, firstIndex, vertexOffset, firstInstance
  EXPECT_EQ(drawCells(device(), {6, 2, 6, 12, 0}, 0, 1, 0, true),
            (Row{0, 0, 0, 4, 5, 0, 0, 0}));
}

GPU_TEST(Indirect, NoInstancesDrawNothing) {
  EXPECT_EQ(drawCells(device(), {6, 0, 0, 0}, 0, 1, 0, false), Row(8, 0));
}

GPU_TEST(Indirect, SeveralDraws) {
  if (!device().supports(rhi::Feature::MultiDrawIndirect)) GTEST_SKIP();
  EXPECT_EQ(drawCells(device(), {6, 1, 0, 0, 6, 0, 6, 0, 6, 1, 24, 0}, 0, 3, 0, false),
            (Row{1, 0, 0, 0, 5, 0, 0, 0}));
  EXPECT_EQ(drawCells(device(), {6, 1, 0, 0, 77, 77, 6, 2, 36, 0, 77, 77}, 0, 2, 24, false),
            (Row{1, 0, 0, 0, 0, 0, 7, 8}));
  EXPECT_EQ(drawCells(device(), {6, 1, 0, 6, 0, 6, 1, 18, 0, 0}, 0, 2, 0, true),
            (Row{0, 2, 0, 4, 0, 0, 0, 0}));
}
