// Queries: exact occlusion, statistics where the API defines them, stamps that never run back.
#include "tests/rhi/resource_helpers.h"

using namespace sb::test;

namespace {
constexpr uint32_t kSize = 50;
}

GPU_TEST(Queries, OcclusionCountsSamplesExactly) {
  if (!device().supports(rhi::Feature::PreciseOcclusion)) GTEST_SKIP();
  rhi::Texture depth =
      texture2D(device(), rhi::Format::D32Float, kSize, kSize, rhi::TextureUse::DepthTarget);
  auto desc = graphics("fullscreen", "");
  desc.depthFormat = rhi::Format::D32Float;
  desc.depth = {.test = true, .write = true, .compare = rhi::CompareOp::Less};
  rhi::Pipeline pipeline = device().createPipeline(desc);
  rhi::QueryPool pool = device().createQueryPool(
      {.label = "occlusion", .kind = rhi::QueryKind::Occlusion, .count = 5});
  frame(device(), [&](rhi::CommandList& list) {
    auto pass = list.beginPass(
        {.label = "occlusion", .depth = rhi::DepthAttachment{.view = {.texture = depth}}});
    auto draw = [&](uint32_t query, rhi::Rect scissor) {
      list.beginQuery(pool, query);
      list.draw({.pipeline = pipeline, .scissor = scissor}, {.vertexCount = 3});
      list.endQuery(pool, query);
    };
    draw(1, {0, 0, 10, 7});
    draw(2, {0, 0, 20, 9});        // 70 of its pixels have the same depth already
    draw(3, {0, 0, 20, 9});
    draw(4, {0, 0, kSize, kSize});
    list.beginQuery(pool, 0);
    list.endQuery(pool, 0);
  });
  EXPECT_EQ(device().readQueries(pool, 0, 5),
            (std::vector<uint64_t>{0, 70, 180 - 70, 0, kSize * kSize - 180}));
  EXPECT_EQ(device().readQueries(pool, 2, 1), std::vector<uint64_t>{110});
}

GPU_TEST(Queries, StatisticsOfADraw) {
  if (!device().supports(rhi::Feature::PipelineStatistics)) GTEST_SKIP();
  rhi::Texture target =
      texture2D(device(), rhi::Format::R32Uint, kSize, kSize, rhi::TextureUse::ColorTarget);
  rhi::Pipeline pipeline =
      device().createPipeline(graphics("fullscreen", "coordinates", {rhi::Format::R32Uint}));
  rhi::QueryPool pool = device().createQueryPool(
      {.label = "statistics", .kind = rhi::QueryKind::PipelineStatistics, .count = 2});
  frame(device(), [&](rhi::CommandList& list) {
    const rhi::ColorAttachment color{.view = {.texture = target}};
    auto pass = list.beginPass({.label = "statistics", .colors = {&color, 1}});
    list.beginQuery(pool, 0);
    list.draw({.pipeline = pipeline}, {.vertexCount = 3, .instanceCount = 4});
    list.endQuery(pool, 0);
    list.beginQuery(pool, 1);
    list.endQuery(pool, 1);
  });
  const auto values = device().readQueries(pool, 0, 2);
  EXPECT_EQ(values[0], 12u) << "input vertices";
  EXPECT_EQ(values[1], 4u) << "input primitives";
  EXPECT_GE(values[2], 3u) << "vertex invocations";
  EXPECT_LE(values[2], 12u);
  EXPECT_EQ(values[3], 4u) << "clipping invocations";
  EXPECT_GE(values[4], 4u) << "clipping primitives";
  EXPECT_GE(values[5], uint64_t(kSize) * kSize) << "fragment invocations";
  EXPECT_EQ(values[6], 0u) << "compute invocations";
  for (size_t i = 7; i < 14; ++i) EXPECT_EQ(values[i], 0u) << "an empty query, value " << i - 7;
}

GPU_TEST(Queries, StatisticsOfADispatch) {
  if (!device().supports(rhi::Feature::PipelineStatistics)) GTEST_SKIP();
  rhi::Buffer out = bufferOf(device(), std::vector<uint32_t>(80));
  rhi::Pipeline pipeline = computePipeline(device(), "fill_index");
  rhi::QueryPool pool = device().createQueryPool(
      {.label = "statistics", .kind = rhi::QueryKind::PipelineStatistics, .count = 1});
  frame(device(), [&](rhi::CommandList& list) {
    const rhi::ResourceUse writes[] = {rhi::use(out, rhi::Access::StorageWrite)};
    auto pass = list.beginPass({.label = "dispatch", .compute = true, .writes = writes});
    list.beginQuery(pool, 0);
    const rhi::Binding bindings[] = {rhi::storageAt(0, out)};
    list.dispatch({.pipeline = pipeline, .bindings = bindings}, 10);
    list.endQuery(pool, 0);
  });
  EXPECT_EQ(device().readQueries(pool, 0, 1),
            (std::vector<uint64_t>{0, 0, 0, 0, 0, 0, 80}));
}

GPU_TEST(Queries, TimestampsNeverRunBackAndSeeTheWork) {
  if (device().info().limits.timestampBits == 0) GTEST_SKIP() << "no timestamps";
  constexpr uint32_t kBig = 1024;
  rhi::Texture target =
      texture2D(device(), rhi::Format::R32Uint, kBig, kBig, rhi::TextureUse::ColorTarget);
  rhi::Pipeline pipeline =
      device().createPipeline(graphics("fullscreen", "coordinates", {rhi::Format::R32Uint}));
  rhi::QueryPool pool =
      device().createQueryPool({.label = "stamps", .kind = rhi::QueryKind::Timestamp, .count = 4});
  for (int repeat = 0; repeat < 2; ++repeat)  // the first frame compiles
    frame(device(), [&](rhi::CommandList& list) {
      list.timestamp(pool, 0);
      list.timestamp(pool, 1);
      {
        const rhi::ColorAttachment color{.view = {.texture = target}};
        auto pass = list.beginPass({.label = "work", .colors = {&color, 1}});
        list.draw({.pipeline = pipeline}, {.vertexCount = 3});
      }
      list.timestamp(pool, 2);
      list.timestamp(pool, 3);
    });
  const auto stamps = device().readQueries(pool, 0, 4);
  for (size_t i = 1; i < 4; ++i) EXPECT_GE(stamps[i], stamps[i - 1]) << i;
  EXPECT_GT(stamps[2] - stamps[1], 0u);
  // A million pixels cost more than nothing at all does.
  EXPECT_GT(stamps[2] - stamps[1], stamps[3] - stamps[2]);
}
