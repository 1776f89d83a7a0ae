// Stencil: two faces, all operations, masks, and the depth-fail count of shadow volumes.
#include "tests/rhi/raster_fixture.h"

using namespace sb::test;

namespace {

constexpr rhi::Format kFormats[] = {rhi::Format::D24UnormS8, rhi::Format::D32FloatS8};

rhi::Pipeline stencilPipeline(rhi::Device& device, rhi::Format format,
                              const rhi::StencilState& stencil) {
  return makePipeline(device, [&](rhi::GraphicsPipelineDesc& d) {
    d.fragment = nullptr;
    d.targets.clear();
    d.depth = {.test = true, .write = false, .compare = rhi::CompareOp::Less};
    d.stencil = stencil;
    d.stencil.test = true;
    d.depthFormat = format;
  });
}

rhi::PassDesc stencilPass(const rhi::Texture& depth, uint8_t clear) {
  return {.label = "stencil",
          .depth = rhi::DepthAttachment{
              .view = {depth.id()}, .clearDepth = 0.5f, .clearStencil = clear}};
}

std::vector<uint8_t> stencilOf(rhi::Device& device, const rhi::Texture& depth) {
  return texels<uint8_t>(device, depth, {}, rhi::Aspect::Stencil);
}

}  // namespace

GPU_TEST(RasterStencil, DepthFailCountsBothFacesInOneDraw) {
  using Op = rhi::StencilOp;
  for (rhi::Format format : kFormats) {
    if (!device().formatCaps(format).depthTarget) continue;
    SCOPED_TRACE(rhi::formatInfo(format).name);
    const rhi::Texture depth = makeTarget(device(), format);
    const rhi::Pipeline pipeline = stencilPipeline(
        device(), format,
        {.front = {.depthFail = Op::DecrementWrap}, .back = {.depthFail = Op::IncrementWrap}});
    // Behind the surface at 0.5 everything fails; before it nothing counts.
    Vertices volume = quad(0, 0, 2, 8, 0.75f);
    for (const Vertices& part : {reversed(quad(2, 0, 4, 8, 0.75f)), quad(4, 0, 6, 8, 0.25f),
                                 quad(6, 0, 8, 4, 0.75f), reversed(quad(6, 0, 8, 8, 0.75f))})
      volume.insert(volume.end(), part.begin(), part.end());
    render(device(), stencilPass(depth, 0), {{pipeline, volume}});
    const auto got = stencilOf(device(), depth);
    EXPECT_EQ(got[at(0, 0)], 255) << "a front face decrements, wrapping";
    EXPECT_EQ(got[at(2, 0)], 1) << "a back face increments";
    EXPECT_EQ(got[at(4, 0)], 0) << "what passes the depth test is not counted";
    EXPECT_EQ(got[at(6, 0)], 0) << "front and back cancel";
    EXPECT_EQ(got[at(6, 7)], 1);
  }
}

GPU_TEST(RasterStencil, EveryOperation) {
  using Op = rhi::StencilOp;
  struct Case {
    Op op;
    uint8_t before, after;
  };
  const rhi::Format format = rhi::Format::D32FloatS8;
  if (!device().formatCaps(format).depthTarget) GTEST_SKIP();
  for (const Case& c : {Case{Op::Keep, 7, 7}, Case{Op::Zero, 7, 0}, Case{Op::Replace, 7, 42},
                        Case{Op::IncrementClamp, 255, 255}, Case{Op::DecrementClamp, 0, 0},
                        Case{Op::Invert, 0x0F, 0xF0}, Case{Op::IncrementWrap, 255, 0},
                        Case{Op::DecrementWrap, 0, 255}, Case{Op::IncrementWrap, 7, 8}}) {
    SCOPED_TRACE(int(c.op));
    const rhi::Texture depth = makeTarget(device(), format);
    const rhi::Pipeline pipeline =
        stencilPipeline(device(), format, {.front = {.pass = c.op}, .back = {.pass = c.op}});
    render(device(), stencilPass(depth, c.before),
           {{pipeline, quad(0, 0, 4, 8, 0.25f), {.stencilReference = 42}}});
    const auto got = stencilOf(device(), depth);
    EXPECT_EQ(got[at(1, 1)], c.after);
    EXPECT_EQ(got[at(6, 1)], c.before);
  }
}

GPU_TEST(RasterStencil, ReferenceMasksAndFailure) {
  using Op = rhi::StencilOp;
  const rhi::Format format = rhi::Format::D32FloatS8;
  if (!device().formatCaps(format).depthTarget) GTEST_SKIP();
  const rhi::Texture depth = makeTarget(device(), format);
  const rhi::StencilFace face = {
      .compare = rhi::CompareOp::Equal, .fail = Op::Invert, .pass = Op::Replace};
  // Only the low half is compared and only bits 4 to 6 are written.
  const rhi::Pipeline pipeline = stencilPipeline(
      device(), format, {.front = face, .back = face, .readMask = 0x0F, .writeMask = 0x70});
  render(device(), stencilPass(depth, 0x85),
         {{pipeline, quad(0, 0, 4, 8, 0.25f), {.stencilReference = 0x35}},
          {pipeline, quad(4, 0, 8, 8, 0.25f), {.stencilReference = 0x34}}});
  const auto got = stencilOf(device(), depth);
  EXPECT_EQ(got[at(1, 1)], 0xB5) << "equal in the masked bits: replaced within the write mask";
  EXPECT_EQ(got[at(6, 1)], 0xF5) << "unequal: inverted within the write mask";
}

GPU_TEST(RasterStencil, StencilIsClearedAndWrittenWhileDepthIsReadAndSampled) {
  // Light after light of a shadow volume technique: depth stays and is sampled, stencil starts
  // anew.
  const rhi::Format format = rhi::Format::D32FloatS8;
  if (!device().formatCaps(format).depthTarget) GTEST_SKIP();
  const rhi::Texture depth = makeTarget(device(), format);
  const rhi::Texture target = makeTarget(device(), rhi::Format::RGBA32Float);
  const rhi::Pipeline fill = makePipeline(device(), [&](rhi::GraphicsPipelineDesc& d) {
    d.fragment = nullptr;
    d.targets.clear();
    d.depth = {.test = true, .write = true, .compare = rhi::CompareOp::Less};
    d.depthFormat = format;
  });
  render(device(),
         {.label = "depth", .depth = rhi::DepthAttachment{.view = {depth.id()}, .clearStencil = 9}},
         {{fill, quad(0, 0, 4, 8, 0.25f)}});
  const rhi::Sampler sampler =
      device().createSampler({.label = "nearest", .filter = rhi::Filter::Nearest});
  const rhi::StencilFace count = {.pass = rhi::StencilOp::IncrementWrap};
  const rhi::Pipeline pipeline = makePipeline(device(), [&](auto& d) {
    d.fragment = &testShaders().get("raster/sample_depth.frag");
    d.depth = {.test = true, .write = false, .compare = rhi::CompareOp::Less};
    d.stencil = {.test = true, .front = count, .back = count};
    d.depthFormat = format;
  });
  const rhi::ResourceUse read = rhi::use(depth.id(), rhi::Access::Sampled);
  const rhi::Binding bindings[] = {rhi::textureAt(0, depth.id(), sampler)};
  for (const uint8_t start : {uint8_t(3), uint8_t(5)}) {
    const rhi::ColorAttachment color = {.view = {target.id()}};
    render(device(),
           {.label = "light",
            .colors = {&color, 1},
            .depth = rhi::DepthAttachment{.view = {depth.id()},
                                          .load = rhi::LoadOp::Load,
                                          .readOnly = true,
                                          .clearStencil = start},
            .reads = {&read, 1}},
           {{pipeline, quad(0, 0, 8, 4, 0.125f), {.bindings = bindings}},
            {pipeline, quad(0, 4, 8, 8, 0.5f), {.bindings = bindings}}});
    const auto stencil = stencilOf(device(), depth);
    EXPECT_EQ(stencil[at(1, 1)], start + 1);
    EXPECT_EQ(stencil[at(1, 6)], start) << "hidden behind 0.25";
    EXPECT_EQ(stencil[at(6, 6)], start + 1);
    EXPECT_EQ(texels<float>(device(), depth)[at(1, 1)], 0.25f) << "left as it was";
    EXPECT_EQ(texels<Color>(device(), target)[at(1, 1)][0], 0.25f);
  }
}

GPU_TEST(RasterStencil, DepthIsClearedAndWrittenWhileStencilIsKept) {
  const rhi::Format format = rhi::Format::D32FloatS8;
  if (!device().formatCaps(format).depthTarget) GTEST_SKIP();
  const rhi::Texture depth = makeTarget(device(), format);
  const rhi::StencilFace equal = {.compare = rhi::CompareOp::Equal};
  const auto pipelineOf = [&](const rhi::StencilFace& face) {
    return makePipeline(device(), [&](rhi::GraphicsPipelineDesc& d) {
      d.fragment = nullptr;
      d.targets.clear();
      d.depth = {.test = true, .write = true, .compare = rhi::CompareOp::Less};
      d.stencil = {.test = true, .front = face, .back = face};
      d.depthFormat = format;
    });
  };
  const rhi::Pipeline mark = pipelineOf({.pass = rhi::StencilOp::Replace});
  const rhi::Pipeline inside = pipelineOf(equal);
  render(device(), {.label = "mark", .depth = rhi::DepthAttachment{.view = {depth.id()}}},
         {{mark, quad(0, 0, 4, 8, 0.25f), {.stencilReference = 7}}});
  render(device(),
         {.label = "inside",
          .depth =
              rhi::DepthAttachment{
                  .view = {depth.id()}, .stencilLoad = rhi::LoadOp::Load, .stencilReadOnly = true}},
         {{inside, quad(0, 0, 8, 8, 0.75f), {.stencilReference = 7}}});
  EXPECT_EQ(stencilOf(device(), depth)[at(1, 1)], 7);
  const auto depths = texels<float>(device(), depth);
  EXPECT_EQ(depths[at(1, 1)], 0.75f);
  EXPECT_EQ(depths[at(6, 1)], 1.0f) << "stencil is 0 there";
}
