// sRGB textures decode when sampled, encode when rendered to, and blend in linear light.
#include <cmath>

#include "tests/rhi/resource_helpers.h"

using namespace sb::test;

namespace {

float decode(float s) { return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f); }
float encode(float l) {
  return l <= 0.0031308f ? l * 12.92f : 1.055f * std::pow(l, 1 / 2.4f) - 0.055f;
}

using Rgba8 = std::array<uint8_t, 4>;

void expectByte(uint8_t actual, float expected) {
  EXPECT_NEAR(float(actual), expected * 255, 1.0f);
}

}  // namespace

GPU_TEST(Srgb, SamplingDecodesColorButNotAlpha) {
  rhi::Texture ramp =
      texture2D(device(), rhi::Format::RGBA8Srgb, 16, 1, rhi::TextureUse::Sampled);
  std::vector<uint8_t> bytes;
  for (int i = 0; i < 16; ++i)
    for (int c = 0; c < 4; ++c) bytes.push_back(uint8_t(i * 17));
  device().upload(ramp, {}, bytesOf(bytes));
  std::vector<Vec4> at;
  for (int i = 0; i < 16; ++i) at.push_back({(float(i) + 0.5f) / 16, 0.5f, 0, 0});
  const auto values = sampleAt(device(), "sample_2d", {.texture = ramp},
                               {.filter = rhi::Filter::Nearest}, at);
  for (int i = 0; i < 16; ++i) {
    const float s = float(i * 17) / 255, l = decode(s);
    // llvmpipe decodes by a polynomial that is off by up to 0.0012.
    expectNear(values[size_t(i)], {l, l, l, s}, 2e-3f, "texel " + std::to_string(i));
  }
}

GPU_TEST(Srgb, RenderingEncodesAndBlendsInLinearLight) {
  rhi::Texture target =
      texture2D(device(), rhi::Format::RGBA8Srgb, 2, 2, rhi::TextureUse::ColorTarget);
  rhi::Buffer color = bufferOf(device(), std::vector<float>{0.5f, 0.1f, 0.002f, 0.5f});
  auto desc = graphics("fullscreen", "constant", {rhi::Format::RGBA8Srgb});
  rhi::Pipeline opaque = device().createPipeline(desc);
  desc.label = "blended";
  desc.targets[0].blend = {.enabled = true,
                           .srcColor = rhi::BlendFactor::SrcAlpha,
                           .dstColor = rhi::BlendFactor::OneMinusSrcAlpha};
  rhi::Pipeline blended = device().createPipeline(desc);
  auto draw = [&](rhi::PipelineId pipeline) {
    frame(device(), [&](rhi::CommandList& list) {
      const rhi::ColorAttachment attachment{.view = {.texture = target},
                                            .clear = {1, 0.25f, 0, 1}};
      auto pass = list.beginPass({.label = "srgb", .colors = {&attachment, 1}});
      const rhi::Binding bindings[] = {rhi::uniformAt(0, color)};
      list.draw({.pipeline = pipeline, .bindings = bindings, .scissor = rhi::Rect{0, 0, 1, 1}},
                {.vertexCount = 3});
    });
    return readTexels<Rgba8>(device(), target);
  };
  const auto plain = draw(opaque);
  expectByte(plain[0][0], encode(0.5f));
  expectByte(plain[0][1], encode(0.1f));
  expectByte(plain[0][2], encode(0.002f));
  expectByte(plain[0][3], 0.5f);
  expectByte(plain[3][1], encode(0.25f));  // clear values are linear as well
  const auto mixed = draw(blended);
  expectByte(mixed[0][0], encode(0.75f));
  expectByte(mixed[0][1], encode(0.175f));
}
