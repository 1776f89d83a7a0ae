// Rows, winding, viewport, scissor and the provoking vertex: one memory layout and one handedness
// on every API (facts.md).
#include <algorithm>

#include "tests/rhi/raster_fixture.h"

using namespace sb::test;

namespace {

/// Draws into a fresh RGBA32F target and returns it texel by texel.
std::vector<Color> picture(rhi::Device& device, const std::vector<DrawCall>& draws) {
  const rhi::Texture target = makeTarget(device, rhi::Format::RGBA32Float);
  const rhi::ColorAttachment color = {.view = {target.id()}};
  render(device, {.label = "picture", .colors = {&color, 1}}, draws);
  return texels<Color>(device, target);
}

uint32_t covered(const std::vector<Color>& picture) {
  return uint32_t(std::ranges::count_if(picture, [](const Color& c) { return c[3] != 0; }));
}

const Color kRed = {1, 0, 0, 1}, kGreen = {0, 1, 0, 1}, kBlue = {0, 0, 1, 1}, kNone = {};

}  // namespace

GPU_TEST(RasterOrientation, AsymmetricPictureLandsInTheRowsOfItsClipSpace) {
  const rhi::Pipeline pipeline = makePipeline(device());
  const auto got = picture(device(), {{pipeline, quad(1, 0, 3, 2, 0, kRed)},
                                      {pipeline, quad(5, 6, 8, 7, 0, kGreen)},
                                      {pipeline, quad(0, 3, 1, 8, 0, kBlue)}});
  for (uint32_t y = 0; y < kSide; ++y)
    for (uint32_t x = 0; x < kSide; ++x) {
      const bool red = x >= 1 && x < 3 && y < 2;
      const bool green = x >= 5 && y == 6;
      const bool blue = x == 0 && y >= 3;
      EXPECT_EQ(got[at(x, y)], red     ? kRed
                               : green ? kGreen
                               : blue  ? kBlue
                                       : kNone)
          << "texel " << x << "," << y;
    }
}

GPU_TEST(RasterOrientation, FragCoordCountsRowsFromClipMinusOne) {
  const rhi::Pipeline pipeline = makePipeline(
      device(), [](auto& d) { d.fragment = &testShaders().get("raster/fragcoord.frag"); });
  const auto got = picture(device(), {{pipeline, fullQuad(0.25f)}});
  for (uint32_t y = 0; y < kSide; ++y)
    for (uint32_t x = 0; x < kSide; ++x)
      EXPECT_EQ(got[at(x, y)], (Color{x + 0.5f, y + 0.5f, 0.25f, 1}));
}

GPU_TEST(RasterOrientation, CounterClockwiseWithYUpIsTheFront) {
  auto count = [&](rhi::CullMode cull, const Vertices& vertices) {
    const rhi::Pipeline pipeline = makePipeline(device(), [&](auto& d) { d.raster.cull = cull; });
    return covered(picture(device(), {{pipeline, vertices}}));
  };
  // Lower left, lower right, upper left in a system with y up: counter-clockwise.
  const Vertices front = {{{-1, -1, 0, 1}}, {{1, -1, 0, 1}}, {{-1, 1, 0, 1}}};
  const uint32_t all = count(rhi::CullMode::None, front);
  EXPECT_GT(all, 0u);
  EXPECT_EQ(count(rhi::CullMode::Back, front), all);
  EXPECT_EQ(count(rhi::CullMode::Front, front), 0u);
  EXPECT_EQ(count(rhi::CullMode::Back, reversed(front)), 0u);
  EXPECT_EQ(count(rhi::CullMode::Front, reversed(front)), all);
}

GPU_TEST(RasterOrientation, FrontFacingAgreesWithCulling) {
  const rhi::Pipeline pipeline = makePipeline(
      device(), [](auto& d) { d.fragment = &testShaders().get("raster/facing.frag"); });
  const auto got =
      picture(device(), {{pipeline, quad(0, 0, 4, 8)}, {pipeline, reversed(quad(4, 0, 8, 8))}});
  EXPECT_EQ(got[at(1, 5)], kRed);
  EXPECT_EQ(got[at(6, 5)], kGreen);
}

GPU_TEST(RasterOrientation, ViewportMapsClipSpaceIntoItsRectangle) {
  const rhi::Pipeline pipeline = makePipeline(device());
  const rhi::DrawState state = {.viewport = rhi::Viewport{2, 1, 4, 6, 0, 1}};
  // The lower half in clip space (y < 0) fills the viewport's rows with the smaller numbers.
  const auto got = picture(device(), {{pipeline, quad(0, 0, 8, 4, 0, kRed), state}});
  for (uint32_t y = 0; y < kSide; ++y)
    for (uint32_t x = 0; x < kSide; ++x)
      EXPECT_EQ(got[at(x, y)], (x >= 2 && x < 6 && y >= 1 && y < 4 ? kRed : kNone))
          << "texel " << x << "," << y;
}

GPU_TEST(RasterOrientation, ScissorCutsInTexels) {
  const rhi::Pipeline pipeline = makePipeline(device());
  rhi::DrawState inside = {.scissor = rhi::Rect{1, 5, 3, 2}};
  rhi::DrawState hanging = {.scissor = rhi::Rect{-4, -2, 5, 3}};
  const auto got = picture(
      device(), {{pipeline, fullQuad(0, kRed), inside}, {pipeline, fullQuad(0, kGreen), hanging}});
  for (uint32_t y = 0; y < kSide; ++y)
    for (uint32_t x = 0; x < kSide; ++x) {
      const bool red = x >= 1 && x < 4 && y >= 5 && y < 7;
      const bool green = x == 0 && y == 0;
      EXPECT_EQ(got[at(x, y)], red ? kRed : green ? kGreen : kNone) << "texel " << x << "," << y;
    }
}

GPU_TEST(RasterOrientation, FirstVertexProvokes) {
  auto pipelineOf = [&](rhi::Topology topology) {
    return makePipeline(device(), [&](auto& d) {
      d.vertex = &testShaders().get("raster/flat.vert");
      d.fragment = &testShaders().get("raster/flat.frag");
      d.topology = topology;
    });
  };
  const rhi::Pipeline list = pipelineOf(rhi::Topology::TriangleList);
  const auto one =
      picture(device(),
              {{list, {{{-1, -1, 0, 1}, kRed}, {{3, -1, 0, 1}, kGreen}, {{-1, 3, 0, 1}, kBlue}}}});
  EXPECT_EQ(one[at(3, 3)], kRed);
  // The second triangle of a strip is provoked by the strip's second vertex.
  const rhi::Pipeline strip = pipelineOf(rhi::Topology::TriangleStrip);
  const auto two = picture(device(), {{strip,
                                       {{{-1, -1, 0, 1}, kRed},
                                        {{1, -1, 0, 1}, kGreen},
                                        {{-1, 1, 0, 1}, kBlue},
                                        {{1, 1, 0, 1}, kBlue}}}});
  EXPECT_EQ(two[at(0, 0)], kRed);
  EXPECT_EQ(two[at(7, 7)], kGreen);
}
