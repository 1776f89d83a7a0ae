// Blending: every operation on every float and unorm format that techniques accumulate in,
// independent per target, dual-source, constants, write masks, and logic operations.
#include <algorithm>
#include <cmath>

#include "tests/rhi/raster_fixture.h"

using namespace sb::test;

namespace {

using F = rhi::BlendFactor;
using Op = rhi::BlendOp;

float fromHalf(uint16_t half) {
  const int exponent = half >> 10 & 31;
  const float fraction = float(half & 1023) / 1024;
  const float value =
      exponent == 0 ? std::ldexp(fraction, -14) : std::ldexp(1 + fraction, exponent - 15);
  return half & 0x8000 ? -value : value;
}

/// The texel as four floats; channels the format lacks are left out by `channels`.
std::vector<float> texelAt(rhi::Device& device, rhi::TextureId texture, rhi::Format format,
                           uint32_t x, uint32_t y) {
  const rhi::TextureRegion region = {.x = x, .y = y, .width = 1, .height = 1};
  std::vector<float> out;
  if (format == rhi::Format::RGBA8Unorm)
    for (uint8_t v : texels<uint8_t>(device, texture, region)) out.push_back(float(v) / 255);
  else if (format == rhi::Format::RGBA16Float)
    for (uint16_t v : texels<uint16_t>(device, texture, region)) out.push_back(fromHalf(v));
  else
    out = texels<float>(device, texture, region);
  return out;
}

rhi::BlendState blendOf(Op op, F src, F dst) {
  return {.enabled = true,
          .srcColor = src,
          .dstColor = dst,
          .colorOp = op,
          .srcAlpha = src,
          .dstAlpha = dst,
          .alphaOp = op};
}

struct Case {
  const char* name;
  rhi::BlendState blend;
  float (*expected)(float s, float d);
};
const Case kCases[] = {
    {"add", blendOf(Op::Add, F::One, F::One), [](float s, float d) { return d + s; }},
    {"subtract", blendOf(Op::Subtract, F::One, F::One), [](float s, float d) { return s - d; }},
    {"reverse subtract", blendOf(Op::ReverseSubtract, F::One, F::One),
     [](float s, float d) { return d - s; }},
    {"min", blendOf(Op::Min, F::One, F::One), [](float s, float d) { return std::min(s, d); }},
    {"max", blendOf(Op::Max, F::One, F::One), [](float s, float d) { return std::max(s, d); }},
    {"multiply", blendOf(Op::Add, F::Zero, F::SrcColor), [](float s, float d) { return s * d; }},
};
constexpr rhi::Format kFormats[] = {rhi::Format::R32Float, rhi::Format::RGBA16Float,
                                    rhi::Format::RGBA32Float, rhi::Format::RGBA8Unorm};

void expectBlend(rhi::Device& device, const Case& c, rhi::Format format, Color source,
                 Color before) {
  SCOPED_TRACE(std::string(c.name) + " on " + std::string(rhi::formatInfo(format).name));
  const rhi::Texture target = makeTarget(device, format);
  const rhi::Pipeline pipeline =
      makePipeline(device, [&](auto& d) { d.targets = {{.format = format, .blend = c.blend}}; });
  const rhi::ColorAttachment color = {.view = {target.id()}, .clear = before};
  render(device, {.label = "blend", .colors = {&color, 1}},
         {{pipeline, quad(0, 0, 4, 8, 0, source)}});
  const bool unorm = format == rhi::Format::RGBA8Unorm;
  const auto blended = texelAt(device, target, format, 1, 1);
  const auto untouched = texelAt(device, target, format, 6, 1);
  for (size_t i = 0; i < rhi::formatInfo(format).channels; ++i) {
    const float raw = c.expected(source[i], before[i]);
    const float expected = unorm ? std::clamp(raw, 0.0f, 1.0f) : raw;
    EXPECT_NEAR(blended[i], expected, unorm ? 1.01f / 255 : 0) << "channel " << i;
    EXPECT_NEAR(untouched[i], before[i], unorm ? 0.51f / 255 : 0) << "channel " << i;
  }
}

}  // namespace

GPU_TEST(RasterBlend, EveryOperationOnEveryFormat) {
  for (rhi::Format format : kFormats) {
    if (!device().formatCaps(format).blend) continue;
    for (const Case& c : kCases)
      expectBlend(device(), c, format, {0.5f, 0.25f, 1, 0.75f}, {0.25f, 0.75f, 0.5f, 1});
  }
}

GPU_TEST(RasterBlend, FloatTargetsAddSignedValues) {
  for (rhi::Format format : kFormats) {
    if (format == rhi::Format::RGBA8Unorm || !device().formatCaps(format).blend) continue;
    for (const Case& c : {kCases[0], kCases[2]})
      expectBlend(device(), c, format, {-3, 8, -0.5f, 2}, {1, -16, -0.25f, 0.5f});
  }
}

GPU_TEST(RasterBlend, TargetsBlendIndependently) {
  if (!device().supports(rhi::Feature::IndependentBlend)) GTEST_SKIP();
  const rhi::Format formats[] = {rhi::Format::RGBA32Float, rhi::Format::RGBA16Float,
                                 rhi::Format::R32Float, rhi::Format::RGBA32Float};
  const size_t cases[] = {0, 2, 4, 5};
  const Color source = {0.5f, 0.25f, 1, 0.75f}, before = {0.25f, 0.75f, 0.5f, 1};
  std::vector<rhi::Texture> targets;
  std::vector<rhi::ColorAttachment> colors;
  const rhi::Pipeline pipeline = makePipeline(device(), [&](auto& d) {
    d.fragment = &testShaders().get("raster/four.frag");
    d.targets.clear();
    for (size_t i = 0; i < 4; ++i)
      d.targets.push_back({.format = formats[i], .blend = kCases[cases[i]].blend});
  });
  for (rhi::Format format : formats) {
    targets.push_back(makeTarget(device(), format));
    colors.push_back({.view = {targets.back().id()}, .clear = before});
  }
  render(device(), {.label = "independent", .colors = colors}, {{pipeline, fullQuad(0, source)}});
  for (size_t i = 0; i < 4; ++i) {
    const auto got = texelAt(device(), targets[i], formats[i], 2, 5);
    for (size_t k = 0; k < rhi::formatInfo(formats[i]).channels; ++k)
      EXPECT_EQ(got[k], kCases[cases[i]].expected(source[k], before[k])) << i << " channel " << k;
  }
}

GPU_TEST(RasterBlend, SecondSourceIsAFactor) {
  if (!device().supports(rhi::Feature::DualSourceBlend)) GTEST_SKIP();
  const rhi::Texture target = makeTarget(device(), rhi::Format::RGBA32Float);
  const rhi::Pipeline pipeline = makePipeline(device(), [](auto& d) {
    d.fragment = &testShaders().get("raster/dual.frag");
    d.targets[0].blend = blendOf(Op::Add, F::One, F::Src1Color);
    d.targets[0].blend.dstAlpha = F::OneMinusSrc1Alpha;
  });
  const rhi::ColorAttachment color = {.view = {target.id()}, .clear = {0.5f, 1, 2, 4}};
  render(device(), {.label = "dual", .colors = {&color, 1}},
         {{pipeline, fullQuad(0, {1, 2, 3, 0.5f})}});
  EXPECT_EQ(texels<Color>(device(), target)[at(3, 3)], (Color{1.25f, 2.25f, 5, 4.5f}));
}

GPU_TEST(RasterBlend, ConstantsAndWriteMask) {
  const rhi::Texture target = makeTarget(device(), rhi::Format::RGBA32Float);
  const rhi::Pipeline pipeline = makePipeline(device(), [](auto& d) {
    d.targets[0].blend = blendOf(Op::Add, F::ConstantColor, F::OneMinusConstantColor);
    d.targets[0].writeMask = 0b1011;
  });
  const rhi::ColorAttachment color = {.view = {target.id()}, .clear = {1, 1, 1, 1}};
  const rhi::DrawState first = {.blendConstant = {0.25f, 0.5f, 0.5f, 1}};
  const rhi::DrawState second = {.blendConstant = {0.5f, 0.25f, 0.5f, 0}};
  render(device(), {.label = "constants", .colors = {&color, 1}},
         {{pipeline, quad(0, 0, 4, 8, 0, {3, 3, 3, 3}), first},
          {pipeline, quad(4, 0, 8, 8, 0, {3, 3, 3, 3}), second}});
  const auto got = texels<Color>(device(), target);
  EXPECT_EQ(got[at(1, 1)], (Color{1.5f, 2, 1, 3}));
  EXPECT_EQ(got[at(5, 1)], (Color{2, 1.5f, 1, 1}));
}

GPU_TEST(RasterBlend, LogicOrGathersBits) {
  if (!device().supports(rhi::Feature::LogicOp)) GTEST_SKIP();
  for (rhi::Format format :
       {rhi::Format::R32Uint, rhi::Format::RG32Uint, rhi::Format::RGBA32Uint}) {
    SCOPED_TRACE(rhi::formatInfo(format).name);
    const rhi::Texture target = makeTarget(device(), format);
    const rhi::Pipeline pipeline = makePipeline(device(), [&](auto& d) {
      d.fragment = &testShaders().get("raster/bits.frag");
      d.targets = {{.format = format}};
      d.logicOp = rhi::LogicOp::Or;
    });
    const rhi::ColorAttachment color = {.view = {target.id()}};
    render(device(), {.label = "logic", .colors = {&color, 1}},
           {{pipeline, fullQuad(0, {1, 2, 4, 8})},
            {pipeline, quad(0, 0, 4, 8, 0, {16, 32, 64, 128})},
            {pipeline, quad(0, 0, 4, 8, 0, {17, 1, 0, 8})}});
    const uint32_t channels = rhi::formatInfo(format).channels;
    const auto got = texels<uint32_t>(device(), target);
    const uint32_t twice[] = {17, 35, 68, 136}, once[] = {1, 2, 4, 8};
    for (uint32_t i = 0; i < channels; ++i) {
      EXPECT_EQ(got[at(1, 1) * channels + i], twice[i]) << i;
      EXPECT_EQ(got[at(6, 1) * channels + i], once[i]) << i;
    }
  }
}
