// Attachments: several colours of different kinds, load and clear, single mips and layers, layered
// rendering.
#include <algorithm>

#include "tests/rhi/raster_fixture.h"

using namespace sb::test;

GPU_TEST(RasterAttachments, SeveralColoursOfDifferentKinds) {
  const rhi::Texture unorm = makeTarget(device(), rhi::Format::RGBA8Unorm);
  const rhi::Texture integer = makeTarget(device(), rhi::Format::RGBA16Uint);
  const rhi::Texture scalar = makeTarget(device(), rhi::Format::R32Float);
  const rhi::Pipeline pipeline = makePipeline(device(), [](auto& d) {
    d.fragment = &testShaders().get("raster/distinct.frag");
    d.targets = {{.format = rhi::Format::RGBA8Unorm},
                 {.format = rhi::Format::RGBA16Uint},
                 {.format = rhi::Format::R32Float}};
  });
  const rhi::ColorAttachment colors[] = {{.view = {unorm.id()}, .clear = {0, 0, 0, 1}},
                                         {.view = {integer.id()}, .clear = {1, 2, 3, 4}},
                                         {.view = {scalar.id()}, .clear = {-5, 0, 0, 0}}};
  render(device(), {.label = "several", .colors = colors},
         {{pipeline, quad(0, 0, 4, 8, 0, {1, 0, 1, 1})}});
  using Bytes = std::array<uint8_t, 4>;
  using Words = std::array<uint16_t, 4>;
  const auto a = texels<Bytes>(device(), unorm);
  const auto b = texels<Words>(device(), integer);
  const auto c = texels<float>(device(), scalar);
  EXPECT_EQ(a[at(1, 6)], (Bytes{255, 0, 255, 255}));
  EXPECT_EQ(a[at(6, 6)], (Bytes{0, 0, 0, 255}));
  EXPECT_EQ(b[at(1, 6)], (Words{1, 6, 7, 9}));
  EXPECT_EQ(b[at(6, 6)], (Words{1, 2, 3, 4}));
  EXPECT_EQ(c[at(1, 6)], 8.0f);
  EXPECT_EQ(c[at(6, 6)], -5.0f);
}

GPU_TEST(RasterAttachments, LoadKeepsWhatAnEarlierPassStored) {
  const rhi::Texture target = makeTarget(device(), rhi::Format::RGBA32Float);
  const rhi::Pipeline pipeline = makePipeline(device());
  const rhi::ColorAttachment clear = {.view = {target.id()}, .clear = {1, 2, 3, 4}};
  const rhi::ColorAttachment load = {.view = {target.id()}, .load = rhi::LoadOp::Load};
  render(device(), {.label = "clear", .colors = {&clear, 1}}, {});
  render(device(), {.label = "load", .colors = {&load, 1}},
         {{pipeline, quad(0, 0, 4, 4, 0, {9, 9, 9, 9})}});
  const auto got = texels<Color>(device(), target);
  EXPECT_EQ(got[at(1, 1)], (Color{9, 9, 9, 9}));
  EXPECT_EQ(got[at(5, 1)], (Color{1, 2, 3, 4}));
}

GPU_TEST(RasterAttachments, OneMipOfOneLayer) {
  const rhi::Texture target = makeTarget(device(), rhi::Format::R32Float, 1, 3, 2);
  const rhi::ColorAttachment all = {.view = {.texture = target.id(), .mipCount = 1},
                                    .clear = {1, 0, 0, 0}};
  const rhi::ColorAttachment one = {.view = {.texture = target.id(),
                                             .baseMip = 1,
                                             .mipCount = 1,
                                             .baseLayer = 2,
                                             .layerCount = 1},
                                    .clear = {2, 0, 0, 0}};
  const rhi::ColorAttachment rest = {.view = {.texture = target.id(),
                                              .baseMip = 1,
                                              .mipCount = 1,
                                              .baseLayer = 0,
                                              .layerCount = 2},
                                     .clear = {3, 0, 0, 0}};
  for (const auto* attachment : {&all, &one, &rest})
    render(device(), {.label = "clear a part", .colors = {attachment, 1}}, {});
  auto first = [&](uint32_t mip, uint32_t layer) {
    const auto got = texels<float>(device(), target, {.mip = mip, .layer = layer});
    EXPECT_EQ(got.size(), mip == 0 ? 64u : 16u);
    EXPECT_TRUE(std::ranges::all_of(got, [&](float v) { return v == got[0]; }));
    return got[0];
  };
  for (uint32_t layer = 0; layer < 3; ++layer) EXPECT_EQ(first(0, layer), 1);
  EXPECT_EQ(first(1, 0), 3);
  EXPECT_EQ(first(1, 1), 3);
  EXPECT_EQ(first(1, 2), 2);
}

namespace {

void expectLayers(rhi::Device& device, const rhi::Pipeline& pipeline, uint32_t instances) {
  const rhi::Texture target = makeTarget(device, rhi::Format::RGBA32Float, 1, 3);
  const rhi::Texture depth = makeTarget(device, rhi::Format::D32Float, 1, 3);
  const rhi::ColorAttachment color = {.view = {target.id()}};
  render(device,
         {.label = "layers",
          .colors = {&color, 1},
          .depth = rhi::DepthAttachment{.view = {depth.id()}}},
         {{pipeline, quad(0, 0, 4, 8, 0.25f, {1, 2, 3, 4}), {}, instances}});
  for (uint32_t layer = 0; layer < 3; ++layer) {
    const float k = float(layer + 1);
    const auto got = texels<Color>(device, target, {.layer = layer});
    EXPECT_EQ(got[at(1, 3)], (Color{k, 2 * k, 3 * k, 4 * k})) << "layer " << layer;
    EXPECT_EQ(got[at(6, 3)], Color{}) << "layer " << layer;
    const auto z = texels<float>(device, depth, {.layer = layer});
    EXPECT_EQ(z[at(1, 3)], 0.25f);
    EXPECT_EQ(z[at(6, 3)], 1.0f);
  }
}

void withDepth(rhi::GraphicsPipelineDesc& d) {
  d.depth = {.test = true, .write = true};
  d.depthFormat = rhi::Format::D32Float;
}

}  // namespace

GPU_TEST(RasterAttachments, LayersFromAGeometryShader) {
  if (!device().supports(rhi::Feature::GeometryShader)) GTEST_SKIP();
  const rhi::Pipeline pipeline = makePipeline(device(), [](auto& d) {
    withDepth(d);
    d.geometry = &testShaders().get("raster/layer.geom");
  });
  expectLayers(device(), pipeline, 1);
}

GPU_TEST(RasterAttachments, LayersFromAVertexShader) {
  if (!device().supports(rhi::Feature::VertexLayer)) GTEST_SKIP();
  const rhi::Pipeline pipeline = makePipeline(device(), [](auto& d) {
    withDepth(d);
    d.vertex = &testShaders().get("raster/layer.vert");
  });
  expectLayers(device(), pipeline, 3);
}
