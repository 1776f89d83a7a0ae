// Frames that end in an exception, wherever it strikes: nothing of them is left, and the next frame
// is as if they had not been begun. Validation (which fails a test for any message) checks layouts
// and hazards.
#include "backends/rhi/memory_limit.h"
#include "tests/rhi/resource_helpers.h"

using namespace sb::test;

namespace {

struct Stop {};

/// A frame with everything in it, on objects of its own; throws behind the step `stop`.
class Everything {
 public:
  static constexpr int kSteps = 9;

  explicit Everything(rhi::Device& device) : m_device(device) {
    auto desc = graphics("fullscreen", "coordinates", {rhi::Format::R32Uint});
    m_draw = device.createPipeline(desc);
  }

  void record(rhi::CommandList& list, int stop) {
    const auto at = [&](int step) {
      if (step == stop) throw Stop();
    };
    at(0);
    list.fill(m_log, 0, 32, 0);
    list.write(m_value, 0, std::as_bytes(std::span(&kValue, 1)));
    at(1);
    computePass(list, m_append, {rhi::storageAt(0, m_value), rhi::storageAt(1, m_log)},
                {rhi::use(m_value, rhi::Access::StorageRead)},
                {rhi::use(m_log, rhi::Access::StorageWrite)}, {1, 1, 1});
    at(2);
    if (m_stamps) list.timestamp(m_stamps, 0);
    const rhi::ColorAttachment color{.view = {.texture = m_target}, .clear = {7, 0, 0, 0}};
    {
      auto pass = list.beginPass({.label = "draws", .colors = {&color, 1}});
      at(3);
      if (m_occlusion) list.beginQuery(m_occlusion, 0);
      at(4);
      list.draw({.pipeline = m_draw, .scissor = rhi::Rect{0, 0, 4, 2}}, {.vertexCount = 3});
      at(5);
      if (m_occlusion) list.endQuery(m_occlusion, 0);
    }
    at(6);
    list.copy({.texture = m_target}, {.texture = m_copy});
    at(7);
    list.copy(m_log, 0, m_copied, 0, 32);
    if (m_stamps) list.timestamp(m_stamps, 1);
    at(8);
  }

  void expectDone() {
    EXPECT_EQ(readAll<uint32_t>(m_device, m_copied),
              (std::vector<uint32_t>{1, kValue, 0, 0, 0, 0, 0, 0}));
    const auto texels = readTexels<uint32_t>(m_device, m_copy);
    for (uint32_t y = 0; y < 4; ++y) EXPECT_EQ(texels[y * 4 + 1], y < 2 ? y * 1000 + 1 : 7) << y;
    if (m_occlusion) EXPECT_EQ(m_device.readQueries(m_occlusion, 0, 1)[0], 8u);
    if (m_stamps) {
      const auto stamps = m_device.readQueries(m_stamps, 0, 2);
      EXPECT_LE(stamps[0], stamps[1]);
    }
  }

 private:
  static constexpr uint32_t kValue = 42;
  rhi::Device& m_device;
  rhi::Buffer m_value = bufferOf(m_device, std::vector<uint32_t>{0});
  rhi::Buffer m_log = bufferOf(m_device, std::vector<uint32_t>(8, 9));
  rhi::Buffer m_copied = bufferOf(m_device, std::vector<uint32_t>(8, 9));
  rhi::Texture m_target =
      texture2D(m_device, rhi::Format::R32Uint, 4, 4, rhi::TextureUse::ColorTarget);
  rhi::Texture m_copy = texture2D(m_device, rhi::Format::R32Uint, 4, 4, rhi::TextureUse::Sampled);
  rhi::Pipeline m_append = computePipeline(m_device, "append");
  rhi::Pipeline m_draw;
  rhi::QueryPool m_occlusion = m_device.supports(rhi::Feature::PreciseOcclusion)
                                   ? m_device.createQueryPool({.label = "occlusion",
                                                               .kind = rhi::QueryKind::Occlusion,
                                                               .count = 1})
                                   : rhi::QueryPool();
  rhi::QueryPool m_stamps =
      m_device.info().limits.timestampBits > 0
          ? m_device.createQueryPool(
                {.label = "stamps", .kind = rhi::QueryKind::Timestamp, .count = 2})
          : rhi::QueryPool();
};

void abandonAt(rhi::Device& device, Everything& everything, int step) {
  try {
    rhi::FrameScope frame(device);
    everything.record(frame.commands(), step);
    ADD_FAILURE() << "no exception at step " << step;
  } catch (const Stop&) {
  }
}

}  // namespace

GPU_TEST(Abandon, TheNextFrameIsAsIfNothingHadBeenBegun) {
  for (int step = 0; step < Everything::kSteps; ++step) {
    SCOPED_TRACE(step);
    // New objects, whose first use falls into the frame that is given up; several times in a row.
    Everything everything(device());
    for (int i = 0; i < 3; ++i) abandonAt(device(), everything, step);
    rhi::FrameScope frame(device());
    everything.record(frame.commands(), -1);
    frame.endAndWait();
    everything.expectDone();
  }
}

GPU_TEST(Abandon, BetweenFramesThatWereFinished) {
  Everything everything(device());
  for (int step = 0; step < Everything::kSteps; ++step) {
    SCOPED_TRACE(step);
    {
      rhi::FrameScope frame(device());
      everything.record(frame.commands(), -1);
      frame.end();  // in flight while the next one is given up
    }
    abandonAt(device(), everything, step);
    rhi::FrameScope frame(device());
    everything.record(frame.commands(), -1);
    frame.endAndWait();
    everything.expectDone();
  }
}

GPU_TEST(Abandon, ObjectsMayGoWithTheirFrame) {
  Everything everything(device());
  for (int step = 0; step < Everything::kSteps; ++step) {
    Everything gone(device());
    abandonAt(device(), gone, step);
  }
  rhi::FrameScope frame(device());
  everything.record(frame.commands(), -1);
  frame.endAndWait();
  everything.expectDone();
}

GPU_TEST(Abandon, TransfersBetweenFramesGoOn) {
  Everything everything(device());
  rhi::Buffer buffer = bufferOf(device(), std::vector<uint32_t>{1, 2});
  abandonAt(device(), everything, 7);
  device().upload(buffer, 4, std::as_bytes(std::span("abc", 4)));
  EXPECT_EQ(readAll<uint32_t>(device(), buffer)[0], 1u);
  EXPECT_EQ(device().read(buffer, 4, 4)[1], std::byte('b'));
}

GPU_TEST(Limits, BuffersBeyondTheStorageRangeAreRefusedBeforeUseWithTheSizes) {
  const uint64_t range = device().info().limits.maxStorageRange;
  if (range == 0 || range > (uint64_t(1) << 30)) GTEST_SKIP() << "no buffer of this test is larger";
  rhi::Buffer large = device().createBuffer(
      {.label = "large", .size = range + 4, .use = rhi::BufferUse::Storage | rhi::BufferUse::Vertex});
  rhi::Buffer log = bufferOf(device(), std::vector<uint32_t>(5, 0));
  rhi::Pipeline pipeline = computePipeline(device(), "append");
  try {
    rhi::FrameScope frame(device());
    computePass(frame.commands(), pipeline, {rhi::storageAt(0, large), rhi::storageAt(1, log)},
                {rhi::use(large, rhi::Access::StorageRead)},
                {rhi::use(log, rhi::Access::StorageWrite)}, {1, 1, 1});
    ADD_FAILURE() << "it was bound";
  } catch (const rhi::Error& e) {
    EXPECT_TRUE(rhi::isTooLarge(e));
    EXPECT_NE(rhi::whyTooLarge(e).find("'large' has "), std::string::npos) << e.what();
    EXPECT_NE(rhi::whyTooLarge(e).find(std::to_string(range >> 20) + " MiB"), std::string::npos)
        << e.what();
  }
  // Validation says the same, and that nobody wrote it.
  EXPECT_FALSE(device().takeMessages().empty());
  // A part of it that is within the range may be read.
  rhi::FrameScope frame(device());
  frame.commands().fill(large, 0, 16, 77);
  rhi::Binding part = rhi::storageAt(0, large);
  part.size = 16;
  computePass(frame.commands(), pipeline, {part, rhi::storageAt(1, log)},
              {rhi::use(large, rhi::Access::StorageRead)},
              {rhi::use(log, rhi::Access::StorageWrite)}, {1, 1, 1});
  frame.endAndWait();
  EXPECT_EQ(readAll<uint32_t>(device(), log)[1], 77u);
}
