// The null device keeps contents and records calls.
#include "backends/null/null_backend.h"

#include <gtest/gtest.h>

#include <cstring>

using null_backend::Call;
using null_backend::CallKind;

TEST(NullBackend, KeepsTheContentsOfBuffers) {
  auto device = null_backend::makeBackend()->open({});
  const rhi::Buffer a = device->createBuffer({.label = "a", .size = 16});
  const rhi::Buffer b = device->createBuffer({.label = "b", .size = 16});
  const uint32_t values[] = {1, 2};
  device->upload(a, 0, std::as_bytes(std::span(values)));
  rhi::CommandList& list = device->beginFrame();
  list.fill(a, 8, 8, 7);
  list.copy(a, 4, b, 0, 8);
  list.write(b, 12, std::as_bytes(std::span(values, 1)));
  device->endFrame();
  const std::vector<std::byte> bytes = device->read(b, 0, 16);
  uint32_t got[4];
  std::memcpy(got, bytes.data(), 16);
  EXPECT_EQ(std::vector(got, got + 4), (std::vector<uint32_t>{2, 7, 0, 1}));
}

TEST(NullBackend, KeepsTheContentsOfTextures) {
  auto device = null_backend::makeBackend()->open({});
  const rhi::TextureDesc desc = {.label = "t",
                                 .kind = rhi::TextureKind::Tex2DArray,
                                 .format = rhi::Format::R32Uint,
                                 .width = 4,
                                 .height = 4,
                                 .layers = 2};
  const rhi::Texture a = device->createTexture(desc), b = device->createTexture(desc);
  const uint32_t values[] = {1, 2, 3, 4};
  device->upload(a, {.layer = 1, .x = 1, .y = 2, .width = 2, .height = 2},
                 std::as_bytes(std::span(values)));
  rhi::CommandList& list = device->beginFrame();
  list.copy(rhi::TextureView{a.id()}, rhi::TextureView{b.id()});
  device->endFrame();
  const auto bytes = device->read(b, {.layer = 1, .x = 2, .y = 2, .width = 1, .height = 2});
  uint32_t got[2];
  ASSERT_EQ(bytes.size(), sizeof(got));
  std::memcpy(got, bytes.data(), sizeof(got));
  EXPECT_EQ(got[0], 2u);
  EXPECT_EQ(got[1], 4u);
}

TEST(NullBackend, InstancesThatFollowOneAnotherAreOneCall) {
  auto device = null_backend::makeBackend()->open({});
  const rhi::ShaderCode code = {.name = "v", .stage = rhi::ShaderStage::Vertex};
  const rhi::Pipeline pipeline = device->createPipeline({.label = "p", .vertex = &code});
  rhi::CommandList& list = device->beginFrame();
  {
    auto pass = list.beginPass({.label = "p", .extent = {1, 1}});
    const rhi::DrawIndexedArgs draws[] = {
        {.indexCount = 3, .firstInstance = 4},
        {.indexCount = 3, .instanceCount = 2, .firstInstance = 5},
        {.indexCount = 3, .firstInstance = 8},  // not the next
        {.indexCount = 3, .firstInstance = 8},  // the same again
        {.indexCount = 6, .firstInstance = 9},  // other indices
        {.indexCount = 6, .firstIndex = 3, .firstInstance = 10},
        {.indexCount = 6, .firstIndex = 3, .vertexOffset = 1, .firstInstance = 11},
    };
    list.drawIndexed({.pipeline = pipeline}, draws);
  }
  EXPECT_EQ(list.counters().draws, 7u);
  EXPECT_EQ(list.counters().triangles, 1u + 2 + 1 + 1 + 2 + 2 + 2);
  device->endFrame();
  std::vector<std::vector<uint64_t>> drawn;
  for (const Call& call : null_backend::calls(*device))
    if (call.kind == CallKind::DrawIndexed) drawn.push_back(call.args);
  EXPECT_EQ(drawn, (std::vector<std::vector<uint64_t>>{{3, 3, 0, 0, 4},
                                                       {3, 1, 0, 0, 8},
                                                       {3, 1, 0, 0, 8},
                                                       {6, 1, 0, 0, 9},
                                                       {6, 1, 3, 0, 10},
                                                       {6, 1, 3, 1, 11}}));
}

TEST(NullBackend, RecordsCallsAndMonotoneTimes) {
  auto device = null_backend::makeBackend()->open({});
  const rhi::QueryPool pool = device->createQueryPool({.label = "times", .count = 2});
  const rhi::ShaderCode code = {.name = "c", .stage = rhi::ShaderStage::Compute};
  const rhi::Pipeline kernel =
      device->createPipeline(rhi::ComputePipelineDesc{.label = "kernel", .compute = &code});
  rhi::CommandList& list = device->beginFrame();
  list.timestamp(pool, 0);
  {
    auto pass = list.beginPass({.label = "p", .compute = true});
    list.dispatch({.pipeline = kernel}, 2, 3);
  }
  list.timestamp(pool, 1);
  device->endFrame();
  const std::vector<Call> expected = {{CallKind::Timestamp, "", "", "times", {0}},
                                      {CallKind::BeginPass, "p", "", "", {}},
                                      {CallKind::Dispatch, "p", "kernel", "", {2, 3, 1}},
                                      {CallKind::EndPass, "p", "", "", {}},
                                      {CallKind::Timestamp, "", "", "times", {1}}};
  EXPECT_EQ(null_backend::calls(*device), expected);
  const auto times = device->readQueries(pool, 0, 2);
  EXPECT_LT(times[0], times[1]);
  null_backend::clearCalls(*device);
  EXPECT_TRUE(null_backend::calls(*device).empty());
}

TEST(NullBackend, RefusesConstantsThatNoStageDeclares) {
  auto device = null_backend::makeBackend()->open({});
  const rhi::ShaderCode code = {
      .name = "c", .stage = rhi::ShaderStage::Compute, .constants = {{.id = 3}}};
  rhi::ComputePipelineDesc desc = {.label = "kernel", .compute = &code, .constants = {{3, 1}}};
  device->createPipeline(desc);
  desc.constants = {{4, 1}};
  EXPECT_THROW(device->createPipeline(desc), rhi::Error);
}
