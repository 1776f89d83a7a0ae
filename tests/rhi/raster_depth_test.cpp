// Depth: values, comparisons, clamping, the infinite far plane, and sampling while attached.
#include "tests/rhi/raster_fixture.h"

using namespace sb::test;

namespace {

rhi::Pipeline depthPipeline(rhi::Device& device, rhi::CompareOp compare, bool write,
                            bool clamp = false, rhi::Format format = rhi::Format::D32Float) {
  return makePipeline(device, [&](rhi::GraphicsPipelineDesc& d) {
    d.fragment = nullptr;
    d.targets.clear();
    d.depth = {.test = true, .write = write, .compare = compare};
    d.depthFormat = format;
    d.raster.depthClamp = clamp;
  });
}

rhi::PassDesc depthPass(const rhi::Texture& depth, float clear) {
  return {.label = "depth",
          .depth = rhi::DepthAttachment{.view = {depth.id()}, .clearDepth = clear}};
}

}  // namespace

GPU_TEST(RasterDepth, StoresClipZOverW) {
  const rhi::Texture depth = makeTarget(device(), rhi::Format::D32Float);
  const rhi::Pipeline pipeline = depthPipeline(device(), rhi::CompareOp::Always, true);
  Vertices scaled = quad(4, 0, 8, 4, 0.75f);
  for (Vertex& v : scaled)
    for (float& f : v.position) f *= 2;
  const rhi::DrawState range = {.viewport = rhi::Viewport{0, 0, 8, 8, 0.5f, 1}};
  render(device(), depthPass(depth, 1),
         {{pipeline, quad(0, 0, 4, 4, 0.25f)},
          {pipeline, scaled},
          {pipeline, quad(0, 4, 4, 8, 0.5f), range}});
  const auto got = texels<float>(device(), depth);
  EXPECT_EQ(got[at(1, 1)], 0.25f);
  EXPECT_EQ(got[at(6, 1)], 0.75f);
  EXPECT_EQ(got[at(1, 6)], 0.75f) << "depth range of the viewport";
  EXPECT_EQ(got[at(6, 6)], 1.0f) << "cleared";
}

GPU_TEST(RasterDepth, EveryFormatReadsBack) {
  for (rhi::Format format : {rhi::Format::D16Unorm, rhi::Format::D24Unorm, rhi::Format::D24UnormS8,
                             rhi::Format::D32Float, rhi::Format::D32FloatS8}) {
    if (!device().formatCaps(format).depthTarget) continue;
    SCOPED_TRACE(rhi::formatInfo(format).name);
    const rhi::Texture depth = makeTarget(device(), format);
    const rhi::Pipeline pipeline =
        depthPipeline(device(), rhi::CompareOp::Less, true, false, format);
    render(device(), depthPass(depth, 1), {{pipeline, quad(0, 0, 4, 8, 0.25f)}});
    if (format == rhi::Format::D16Unorm) {
      const auto got = texels<uint16_t>(device(), depth);
      EXPECT_NEAR(got[at(1, 1)], 0.25 * 65535, 1);
      EXPECT_EQ(got[at(6, 1)], 65535);
    } else if (format == rhi::Format::D24Unorm || format == rhi::Format::D24UnormS8) {
      const auto got = texels<uint32_t>(device(), depth);
      EXPECT_NEAR(got[at(1, 1)], 0.25 * 16777215, 1);
      EXPECT_EQ(got[at(6, 1)], 16777215u);
    } else {
      const auto got = texels<float>(device(), depth);
      EXPECT_EQ(got[at(1, 1)], 0.25f);
      EXPECT_EQ(got[at(6, 1)], 1.0f);
    }
  }
}

GPU_TEST(RasterDepth, EveryCompareOp) {
  using Op = rhi::CompareOp;
  struct Case {
    Op op;
    bool less, equal, greater;  // does a fragment pass that is less, equal, greater
  };
  for (const Case& c :
       {Case{Op::Never, false, false, false}, Case{Op::Less, true, false, false},
        Case{Op::Equal, false, true, false}, Case{Op::LessOrEqual, true, true, false},
        Case{Op::Greater, false, false, true}, Case{Op::NotEqual, true, false, true},
        Case{Op::GreaterOrEqual, false, true, true}, Case{Op::Always, true, true, true}}) {
    SCOPED_TRACE(int(c.op));
    const rhi::Texture depth = makeTarget(device(), rhi::Format::D32Float);
    const rhi::Pipeline pipeline = depthPipeline(device(), c.op, true);
    render(device(), depthPass(depth, 0.5f),
           {{pipeline, quad(0, 0, 2, 8, 0.25f)},
            {pipeline, quad(2, 0, 4, 8, 0.5f)},
            {pipeline, quad(4, 0, 6, 8, 0.75f)}});
    const auto got = texels<float>(device(), depth);
    EXPECT_EQ(got[at(0, 0)], c.less ? 0.25f : 0.5f);
    EXPECT_EQ(got[at(2, 0)], 0.5f);
    EXPECT_EQ(got[at(4, 0)], c.greater ? 0.75f : 0.5f);
  }
}

GPU_TEST(RasterDepth, EqualFragmentsPassAsTheOpSays) {
  const rhi::Texture depth = makeTarget(device(), rhi::Format::D32Float);
  const rhi::Texture target = makeTarget(device(), rhi::Format::RGBA32Float);
  auto pipelineOf = [&](rhi::CompareOp op) {
    return makePipeline(device(), [&](auto& d) {
      d.depth = {.test = true, .write = false, .compare = op};
      d.depthFormat = rhi::Format::D32Float;
    });
  };
  const rhi::Pipeline less = pipelineOf(rhi::CompareOp::Less);
  const rhi::Pipeline lessOrEqual = pipelineOf(rhi::CompareOp::LessOrEqual);
  const rhi::ColorAttachment color = {.view = {target.id()}};
  render(device(),
         {.label = "equal",
          .colors = {&color, 1},
          .depth = rhi::DepthAttachment{.view = {depth.id()}, .clearDepth = 0.5f}},
         {{less, quad(0, 0, 4, 8, 0.5f)}, {lessOrEqual, quad(4, 0, 8, 8, 0.5f)}});
  const auto got = texels<Color>(device(), target);
  EXPECT_EQ(got[at(1, 1)][0], 0);
  EXPECT_EQ(got[at(5, 1)][0], 1);
}

GPU_TEST(RasterDepth, ClampKeepsWhatLiesBeyondNearAndFar) {
  if (!device().supports(rhi::Feature::DepthClamp)) GTEST_SKIP();
  const rhi::Texture depth = makeTarget(device(), rhi::Format::D32Float);
  const rhi::Pipeline clamped = depthPipeline(device(), rhi::CompareOp::Always, true, true);
  const rhi::Pipeline clipped = depthPipeline(device(), rhi::CompareOp::Always, true, false);
  render(device(), depthPass(depth, 0.5f),
         {{clamped, quad(0, 0, 2, 8, -0.5f)},
          {clamped, quad(2, 0, 4, 8, 1.5f)},
          {clipped, quad(4, 0, 6, 8, -0.5f)},
          {clipped, quad(6, 0, 8, 8, 1.5f)}});
  const auto got = texels<float>(device(), depth);
  EXPECT_EQ(got[at(1, 3)], 0.0f);
  EXPECT_EQ(got[at(3, 3)], 1.0f);
  EXPECT_EQ(got[at(5, 3)], 0.5f);
  EXPECT_EQ(got[at(7, 3)], 0.5f);
}

GPU_TEST(RasterDepth, VerticesAtInfinity) {
  // w = 0: the triangle leaves the corner texel to the right and upwards without end.
  const rhi::Texture depth = makeTarget(device(), rhi::Format::D32Float);
  const rhi::Pipeline pipeline = depthPipeline(device(), rhi::CompareOp::Less, true);
  const Vertices vertices = {{{-0.5f, -0.5f, 0.25f, 1}}, {{1, 0, 0, 0}}, {{0, 1, 0, 0}}};
  render(device(), depthPass(depth, 1), {{pipeline, vertices}});
  const auto got = texels<float>(device(), depth);
  for (uint32_t y = 0; y < kSide; ++y)
    for (uint32_t x = 0; x < kSide; ++x)
      EXPECT_NEAR(got[at(x, y)], x >= 2 && y >= 2 ? 0.25f : 1.0f, 1e-6) << x << "," << y;
}

GPU_TEST(RasterDepth, ReadOnlyDepthIsTestedAndSampledInOnePass) {
  const rhi::Texture depth = makeTarget(device(), rhi::Format::D32Float);
  const rhi::Texture target = makeTarget(device(), rhi::Format::RGBA32Float);
  const rhi::Pipeline fill = depthPipeline(device(), rhi::CompareOp::Less, true);
  render(device(), depthPass(depth, 1), {{fill, quad(0, 0, 4, 8, 0.25f)}});
  const rhi::Sampler sampler =
      device().createSampler({.label = "nearest", .filter = rhi::Filter::Nearest});
  const rhi::Pipeline pipeline = makePipeline(device(), [](auto& d) {
    d.fragment = &testShaders().get("raster/sample_depth.frag");
    d.depth = {.test = true, .write = false, .compare = rhi::CompareOp::Less};
    d.depthFormat = rhi::Format::D32Float;
  });
  const rhi::ColorAttachment color = {.view = {target.id()}};
  const rhi::ResourceUse reads[] = {rhi::use(depth.id(), rhi::Access::Sampled)};
  const rhi::Binding bindings[] = {rhi::textureAt(0, depth.id(), sampler)};
  render(
      device(),
      {.label = "read-only",
       .colors = {&color, 1},
       .depth =
           rhi::DepthAttachment{.view = {depth.id()}, .load = rhi::LoadOp::Load, .readOnly = true},
       .reads = reads},
      {{pipeline, quad(0, 0, 8, 4, 0.125f), {.bindings = bindings}},
       {pipeline, quad(0, 4, 8, 8, 0.5f), {.bindings = bindings}}});
  const auto got = texels<Color>(device(), target);
  EXPECT_EQ(got[at(1, 1)][0], 0.25f);
  EXPECT_EQ(got[at(6, 1)][0], 1.0f);
  EXPECT_EQ(got[at(1, 6)][0], 0.0f) << "hidden behind 0.25";
  EXPECT_EQ(got[at(6, 6)][0], 1.0f);
  EXPECT_EQ(texels<float>(device(), depth)[at(1, 1)], 0.25f) << "left as it was";
}
