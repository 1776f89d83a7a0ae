// Dispatches: direct, indirect, shared memory.
#include <numeric>

#include "tests/rhi/resource_helpers.h"

using namespace sb::test;

GPU_TEST(Compute, DispatchRunsEveryInvocationOnce) {
  rhi::Buffer out = bufferOf(device(), std::vector<uint32_t>(45, 9));
  rhi::Pipeline pipeline = computePipeline(device(), "fill_index");
  frame(device(), [&](rhi::CommandList& list) {
    computePass(list, pipeline, {rhi::storageAt(0, out, 0, 40 * 4)}, {},
                {rhi::use(out, rhi::Access::StorageWrite)}, {5, 1, 1});
  });
  const auto values = readAll<uint32_t>(device(), out);
  for (uint32_t i = 0; i < 45; ++i) EXPECT_EQ(values[i], i < 40 ? i * 3 + 1 : 9) << i;
}

GPU_TEST(Compute, SharedMemoryReduction) {
  std::vector<uint32_t> values(256);
  std::iota(values.begin(), values.end(), 5u);
  rhi::Buffer in = bufferOf(device(), values);
  rhi::Buffer out = bufferOf(device(), std::vector<uint32_t>(4, 0));
  rhi::Pipeline pipeline = computePipeline(device(), "reduce");
  frame(device(), [&](rhi::CommandList& list) {
    computePass(list, pipeline, {rhi::storageAt(0, in), rhi::storageAt(1, out)},
                {rhi::use(in, rhi::Access::StorageRead)},
                {rhi::use(out, rhi::Access::StorageWrite)}, {4, 1, 1});
  });
  const auto sums = readAll<uint32_t>(device(), out);
  for (size_t i = 0; i < 4; ++i)
    EXPECT_EQ(sums[i], std::accumulate(values.begin() + i * 64, values.begin() + i * 64 + 64, 0u));
}

GPU_TEST(Compute, IndirectDispatchTakesArgumentsWrittenOnTheGpu) {
  rhi::Buffer source = bufferOf(device(), std::vector<uint32_t>{0, 0, 0, 0, 3, 1, 1});
  rhi::Buffer args = bufferOf(device(), std::vector<uint32_t>(7, 0));
  rhi::Buffer out = bufferOf(device(), std::vector<uint32_t>(32, 9));
  rhi::Pipeline copy = computePipeline(device(), "store_words");
  rhi::Pipeline fill = computePipeline(device(), "fill_index");
  frame(device(), [&](rhi::CommandList& list) {
    computePass(list, copy, {rhi::storageAt(0, source), rhi::storageAt(1, args)},
                {rhi::use(source, rhi::Access::StorageRead)},
                {rhi::use(args, rhi::Access::StorageWrite)}, {7, 1, 1});
    const rhi::ResourceUse reads[] = {rhi::use(args, rhi::Access::Indirect)};
    const rhi::ResourceUse writes[] = {rhi::use(out, rhi::Access::StorageWrite)};
    auto pass = list.beginPass(
        {.label = "indirect", .compute = true, .reads = reads, .writes = writes});
    const rhi::Binding bindings[] = {rhi::storageAt(0, out)};
    list.dispatchIndirect({.pipeline = fill, .bindings = bindings}, args, 16);
  });
  const auto values = readAll<uint32_t>(device(), out);
  for (uint32_t i = 0; i < 32; ++i) EXPECT_EQ(values[i], i < 24 ? i * 3 + 1 : 9) << i;
}
