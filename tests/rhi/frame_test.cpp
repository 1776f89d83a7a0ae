// Frames: several in flight keep their own values; transfers happen in order with the passes
// around them; counters count.
#include "tests/rhi/resource_helpers.h"

using namespace sb::test;

namespace {

std::vector<std::byte> word(uint32_t value) {
  std::vector<std::byte> bytes(4);
  std::memcpy(bytes.data(), &value, 4);
  return bytes;
}

void append(rhi::CommandList& list, rhi::PipelineId pipeline, rhi::BufferId value,
            rhi::BufferId log) {
  computePass(list, pipeline, {rhi::storageAt(0, value), rhi::storageAt(1, log)},
              {rhi::use(value, rhi::Access::StorageRead)},
              {rhi::use(log, rhi::Access::StorageWrite)}, {1, 1, 1});
}

}  // namespace

GPU_TEST(Frames, EveryFrameInFlightHasItsOwnValues) {
  constexpr uint32_t kFrames = 20;
  rhi::Buffer value = bufferOf(device(), std::vector<uint32_t>{0});
  rhi::Buffer log = bufferOf(device(), std::vector<uint32_t>(kFrames + 1, 0));
  rhi::Pipeline pipeline = computePipeline(device(), "append");
  std::vector<rhi::Ticket> tickets;
  std::vector<uint32_t> expected = {kFrames};
  for (uint32_t i = 0; i < kFrames; ++i) {
    rhi::CommandList& list = device().beginFrame();
    list.write(value, 0, word(1000 + i));
    append(list, pipeline, value, log);
    tickets.push_back(device().endFrame());
    expected.push_back(1000 + i);
  }
  for (uint32_t i = 1; i < kFrames; ++i) EXPECT_EQ(tickets[i], tickets[i - 1] + 1);
  device().wait(tickets.back());
  device().wait(tickets.front());  // long past
  EXPECT_EQ(readAll<uint32_t>(device(), log), expected);
}

GPU_TEST(Frames, WritesFillsAndCopiesKeepTheirPlaceBetweenPasses) {
  rhi::Buffer value = bufferOf(device(), std::vector<uint32_t>{0});
  rhi::Buffer other = bufferOf(device(), std::vector<uint32_t>{0, 5, 0, 0});
  rhi::Buffer log = bufferOf(device(), std::vector<uint32_t>(8, 9));
  rhi::Pipeline pipeline = computePipeline(device(), "append");
  frame(device(), [&](rhi::CommandList& list) {
    list.fill(log, 0, 32, 0);
    list.write(value, 0, word(1));
    append(list, pipeline, value, log);
    list.fill(value, 0, 4, 2);
    append(list, pipeline, value, log);
    list.copy(other, 4, value, 0, 4);
    append(list, pipeline, value, log);
    list.write(value, 0, word(3));
    list.write(value, 0, word(4));
    list.copy(value, 0, other, 8, 4);
    append(list, pipeline, value, log);
    list.copy(log, 0, other, 12, 4);  // after the stores of a pass
  });
  EXPECT_EQ(readAll<uint32_t>(device(), log), (std::vector<uint32_t>{4, 1, 2, 5, 4, 0, 0, 0}));
  EXPECT_EQ(readAll<uint32_t>(device(), other), (std::vector<uint32_t>{0, 5, 4, 4}));
}

GPU_TEST(Frames, LargeWritesArriveWhole) {
  std::vector<uint32_t> values(3u << 18);
  for (size_t i = 0; i < values.size(); ++i) values[i] = uint32_t(i * 2654435761u);
  rhi::Buffer buffer = device().createBuffer(
      {.label = "large", .size = values.size() * 4 + 8, .use = kAnyBuffer});
  frame(device(), [&](rhi::CommandList& list) { list.write(buffer, 8, bytesOf(values)); });
  EXPECT_EQ(fromBytes<uint32_t>(device().read(buffer, 8, values.size() * 4)), values);
}

GPU_TEST(Frames, CountersCountOneFrame) {
  rhi::Texture target =
      texture2D(device(), rhi::Format::R32Uint, 4, 4, rhi::TextureUse::ColorTarget);
  rhi::Pipeline pipeline =
      device().createPipeline(graphics("fullscreen", "coordinates", {rhi::Format::R32Uint}));
  for (int repeat = 0; repeat < 2; ++repeat)
    frame(device(), [&](rhi::CommandList& list) {
      const rhi::ColorAttachment color{.view = {.texture = target}};
      {
        auto pass = list.beginPass({.label = "draws", .colors = {&color, 1}});
        for (int i = 0; i < 3; ++i)
          list.draw({.pipeline = pipeline}, {.vertexCount = 3, .instanceCount = 2});
      }
      EXPECT_EQ(list.counters(), (rhi::Counters{.passes = 1, .draws = 3, .triangles = 6}));
    });
}

GPU_TEST(Frames, ObjectsMayGoWhileTheirFrameIsInFlight) {
  rhi::Buffer log = bufferOf(device(), std::vector<uint32_t>(5, 0));
  rhi::Pipeline pipeline = computePipeline(device(), "append");
  for (uint32_t i = 0; i < 4; ++i) {
    rhi::Buffer value = bufferOf(device(), std::vector<uint32_t>{i + 10});
    append(device().beginFrame(), pipeline, value, log);
    device().endFrame();
  }
  device().waitIdle();
  EXPECT_EQ(readAll<uint32_t>(device(), log), (std::vector<uint32_t>{4, 10, 11, 12, 13}));
}

GPU_TEST(Frames, LedgerKnowsWhatIsAlive) {
  const uint64_t before = device().ledger().totalBytes();
  {
    rhi::Buffer buffer =
        device().createBuffer({.label = "ledger test", .size = 123, .use = rhi::BufferUse::Storage});
    EXPECT_EQ(device().ledger().totalBytes(), before + 123);
    EXPECT_EQ(device().ledger().bytesByLabel().at("ledger test"), 123u);
  }
  EXPECT_EQ(device().ledger().totalBytes(), before);
}
