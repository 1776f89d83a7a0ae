// Clip space, rows, facing, provoking vertex and depth range: the conventions that both APIs share.
#include "tests/rhi/resource_helpers.h"

using namespace sb::test;

namespace {

constexpr uint32_t kSize = 8;
using Texel = std::array<uint16_t, 4>;

/// Draws triangle.vert's two triangles with a cull mode and returns the picture.
std::vector<Texel> drawTriangles(rhi::Device& device, rhi::CullMode cull) {
  rhi::Texture target = texture2D(device, rhi::Format::RGBA16Uint, kSize, kSize,
                                  rhi::TextureUse::ColorTarget);
  auto desc = graphics("triangle", "facing", {rhi::Format::RGBA16Uint});
  desc.raster.cull = cull;
  rhi::Pipeline pipeline = device.createPipeline(desc);
  frame(device, [&](rhi::CommandList& list) {
    const rhi::ColorAttachment color{.view = {.texture = target}};
    auto pass = list.beginPass({.label = "triangles", .colors = {&color, 1}});
    list.draw({.pipeline = pipeline}, {.vertexCount = 3, .instanceCount = 2});
  });
  return readTexels<Texel>(device, target);
}

}  // namespace

GPU_TEST(Convention, RowZeroIsClipSpaceMinusOne) {
  const auto texels = drawTriangles(device(), rhi::CullMode::None);
  EXPECT_EQ(texels[0], (Texel{0, 0, 1, 10}));  // instance 0: at x = y = -1, counter-clockwise
  EXPECT_EQ(texels[2 * kSize + 0], (Texel{2, 0, 1, 10}));
  EXPECT_EQ(texels[0 * kSize + 2], (Texel{0, 2, 1, 10}));
  EXPECT_EQ(texels[4 * kSize + 4], (Texel{4, 4, 2, 10}));  // instance 1: clockwise
  EXPECT_EQ(texels[4 * kSize + 6], (Texel{4, 6, 2, 10}));
  EXPECT_EQ(texels[0 * kSize + 7], (Texel{0, 0, 0, 0}));
  EXPECT_EQ(texels[7 * kSize + 0], (Texel{0, 0, 0, 0}));
}

GPU_TEST(Convention, CullsByWindingInClipSpace) {
  const auto noFronts = drawTriangles(device(), rhi::CullMode::Front);
  EXPECT_EQ(noFronts[0][2], 0);
  EXPECT_EQ(noFronts[4 * kSize + 4][2], 2);
  const auto noBacks = drawTriangles(device(), rhi::CullMode::Back);
  EXPECT_EQ(noBacks[0][2], 1);
  EXPECT_EQ(noBacks[4 * kSize + 4][2], 0);
}

GPU_TEST(Convention, StencilFacesFollowTheWinding) {
  rhi::Texture depth = texture2D(device(), rhi::Format::D32FloatS8, kSize, kSize,
                                 rhi::TextureUse::DepthTarget);
  auto desc = graphics("triangle", "");
  desc.depthFormat = rhi::Format::D32FloatS8;
  desc.stencil.test = true;
  desc.stencil.front.pass = rhi::StencilOp::IncrementWrap;
  desc.stencil.back.pass = rhi::StencilOp::DecrementWrap;
  rhi::Pipeline pipeline = device().createPipeline(desc);
  frame(device(), [&](rhi::CommandList& list) {
    auto pass = list.beginPass(
        {.label = "stencil",
         .depth = rhi::DepthAttachment{.view = {.texture = depth}, .clearStencil = 10}});
    list.draw({.pipeline = pipeline}, {.vertexCount = 3, .instanceCount = 2});
  });
  const auto stencil = readTexels<uint8_t>(device(), depth, {}, rhi::Aspect::Stencil);
  EXPECT_EQ(stencil[0], 11);
  EXPECT_EQ(stencil[4 * kSize + 4], 9);
  EXPECT_EQ(stencil[7 * kSize], 10);
}

GPU_TEST(Convention, PointCoordinatesGrowWithTheRowAndDepthIsZeroToOne) {
  rhi::Texture target = texture2D(device(), rhi::Format::RGBA32Float, kSize, kSize,
                                  rhi::TextureUse::ColorTarget);
  auto desc = graphics("point", "point", {rhi::Format::RGBA32Float});
  desc.topology = rhi::Topology::PointList;
  rhi::Pipeline pipeline = device().createPipeline(desc);
  frame(device(), [&](rhi::CommandList& list) {
    const rhi::ColorAttachment color{.view = {.texture = target}};
    auto pass = list.beginPass({.label = "point", .colors = {&color, 1}});
    list.draw({.pipeline = pipeline, .viewport = rhi::Viewport{0, 0, 8, 8, 0.25f, 0.75f}},
              {.vertexCount = 1});
  });
  const auto texels = readTexels<Vec4>(device(), target);
  expectNear(texels[1 * kSize + 6], {6.5f / 8, 1.5f / 8, 0.5f, 1}, 1e-6f, "x 6, y 1");
}

GPU_TEST(Convention, ViewportAndScissorCountFromRowZero) {
  rhi::Texture target =
      texture2D(device(), rhi::Format::R32Uint, kSize, kSize, rhi::TextureUse::ColorTarget);
  rhi::Pipeline pipeline =
      device().createPipeline(graphics("fullscreen", "coordinates", {rhi::Format::R32Uint}));
  frame(device(), [&](rhi::CommandList& list) {
    const rhi::ColorAttachment color{.view = {.texture = target}, .clear = {7, 0, 0, 0}};
    auto pass = list.beginPass({.label = "corner", .colors = {&color, 1}});
    list.draw({.pipeline = pipeline,
               .viewport = rhi::Viewport{2, 1, 5, 4},
               .scissor = rhi::Rect{0, 0, 4, 3}},
              {.vertexCount = 3});
  });
  const auto texels = readTexels<uint32_t>(device(), target);
  for (uint32_t y = 0; y < kSize; ++y)
    for (uint32_t x = 0; x < kSize; ++x) {
      const bool inside = x >= 2 && x < 4 && y >= 1 && y < 3;
      EXPECT_EQ(texels[y * kSize + x], inside ? y * 1000 + x : 7) << x << ", " << y;
    }
}
