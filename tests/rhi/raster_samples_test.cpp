// Four samples a texel: coverage, per-sample shading, mask output, per-sample fetch, resolve.
#include <algorithm>

#include "tests/rhi/raster_fixture.h"

using namespace sb::test;

namespace {

bool hasFour(rhi::Device& device) {
  return std::ranges::count(device.info().limits.sampleCounts, 4u) > 0;
}

/// Draws one full quad of ones with a fragment shader into a 4x R32F target, and returns what the
/// samples of every texel hold and what they resolve to.
struct Samples {
  std::vector<Color> each;
  std::vector<float> resolved;
};
Samples drawSamples(rhi::Device& device, const char* fragment, bool sampleShading,
                    const Vertices& vertices) {
  const rhi::Texture multi = makeTarget(device, rhi::Format::R32Float, 4);
  const rhi::Texture single = makeTarget(device, rhi::Format::R32Float);
  const rhi::Texture fetched = makeTarget(device, rhi::Format::RGBA32Float);
  const rhi::Pipeline draw = makePipeline(device, [&](auto& d) {
    d.fragment = &testShaders().get(fragment);
    d.targets = {{.format = rhi::Format::R32Float}};
    d.samples = 4;
    d.sampleShading = sampleShading;
  });
  const rhi::Pipeline fetch = makePipeline(
      device, [](auto& d) { d.fragment = &testShaders().get("raster/fetch_samples.frag"); });
  const rhi::ColorAttachment color = {.view = {multi.id()},
                                      .resolve = rhi::TextureView{single.id()}};
  render(device, {.label = "four samples", .colors = {&color, 1}}, {{draw, vertices}});

  const rhi::Sampler sampler =
      device.createSampler({.label = "nearest", .filter = rhi::Filter::Nearest});
  const rhi::ColorAttachment target = {.view = {fetched.id()}};
  const rhi::ResourceUse reads[] = {rhi::use(multi.id(), rhi::Access::Sampled)};
  const rhi::Binding bindings[] = {rhi::textureAt(0, multi.id(), sampler)};
  render(device, {.label = "fetch", .colors = {&target, 1}, .reads = reads},
         {{fetch, fullQuad(), {.bindings = bindings}}});
  return {texels<Color>(device, fetched), texels<float>(device, single)};
}

}  // namespace

GPU_TEST(RasterSamples, WholeTexelsFillAllSamples) {
  if (!hasFour(device())) GTEST_SKIP();
  const Samples got = drawSamples(device(), "raster/color.frag", false, quad(0, 0, 4, 8));
  EXPECT_EQ(got.each[at(1, 1)], (Color{1, 1, 1, 1}));
  EXPECT_EQ(got.each[at(6, 1)], (Color{0, 0, 0, 0}));
  EXPECT_EQ(got.resolved[at(1, 1)], 1.0f);
  EXPECT_EQ(got.resolved[at(6, 1)], 0.0f);
}

GPU_TEST(RasterSamples, AnEdgeThroughTexelsCoversSomeSamples) {
  if (!hasFour(device())) GTEST_SKIP();
  const Samples got = drawSamples(device(), "raster/color.frag", false, quad(0, 0, 4.5f, 8));
  for (uint32_t y = 0; y < kSide; ++y) {
    const Color& c = got.each[at(4, y)];
    const float covered = c[0] + c[1] + c[2] + c[3];
    EXPECT_EQ(covered, 2) << "half a texel of the standard pattern";
    EXPECT_EQ(got.resolved[at(4, y)], covered / 4);
  }
}

GPU_TEST(RasterSamples, ShaderRunsOncePerSample) {
  if (!hasFour(device()) || !device().supports(rhi::Feature::SampleRateShading)) GTEST_SKIP();
  const Samples got = drawSamples(device(), "raster/sample_id.frag", true, fullQuad());
  for (uint32_t i = 0; i < kSide * kSide; ++i) {
    EXPECT_EQ(got.each[i], (Color{1, 2, 3, 4}));
    EXPECT_EQ(got.resolved[i], 2.5f);
  }
}

GPU_TEST(RasterSamples, MaskOutputSelectsSamples) {
  if (!hasFour(device())) GTEST_SKIP();
  const Samples got = drawSamples(device(), "raster/sample_mask.frag", false, fullQuad());
  for (uint32_t y = 0; y < kSide; ++y)
    for (uint32_t x = 0; x < kSide; ++x) {
      const Color expected = {float(x & 1), float(x >> 1 & 1), float(x >> 2 & 1),
                              float(x >> 3 & 1)};
      EXPECT_EQ(got.each[at(x, y)], expected) << x;
    }
}

GPU_TEST(RasterSamples, DepthIsFetchedPerSample) {
  if (!hasFour(device())) GTEST_SKIP();
  const rhi::Texture depth = makeTarget(device(), rhi::Format::D32Float, 4);
  const rhi::Texture fetched = makeTarget(device(), rhi::Format::RGBA32Float);
  const rhi::Pipeline draw = makePipeline(device(), [](auto& d) {
    d.fragment = nullptr;
    d.targets.clear();
    d.depth = {.test = true, .write = true};
    d.depthFormat = rhi::Format::D32Float;
    d.samples = 4;
  });
  const rhi::Pipeline fetch = makePipeline(
      device(), [](auto& d) { d.fragment = &testShaders().get("raster/fetch_samples.frag"); });
  render(device(), {.label = "depth", .depth = rhi::DepthAttachment{.view = {depth.id()}}},
         {{draw, quad(0, 0, 4, 8, 0.25f)}, {draw, quad(4, 0, 4.5f, 8, 0.5f)}});
  const rhi::Sampler sampler =
      device().createSampler({.label = "nearest", .filter = rhi::Filter::Nearest});
  const rhi::ColorAttachment target = {.view = {fetched.id()}};
  const rhi::ResourceUse reads[] = {rhi::use(depth.id(), rhi::Access::Sampled)};
  const rhi::Binding bindings[] = {rhi::textureAt(0, depth.id(), sampler)};
  render(device(), {.label = "fetch", .colors = {&target, 1}, .reads = reads},
         {{fetch, fullQuad(), {.bindings = bindings}}});
  const auto got = texels<Color>(device(), fetched);
  EXPECT_EQ(got[at(1, 1)], (Color{0.25f, 0.25f, 0.25f, 0.25f}));
  EXPECT_EQ(got[at(6, 1)], (Color{1, 1, 1, 1}));
  const Color& edge = got[at(4, 1)];
  EXPECT_EQ(edge[0] + edge[1] + edge[2] + edge[3], 3.0f) << "two samples at 0.5, two cleared";
}
