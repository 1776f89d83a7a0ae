// What goes into a texture comes out: every format through upload, clear and read-back.
#include <algorithm>
#include <bit>
#include <cmath>

#include "tests/rhi/resource_helpers.h"

using namespace sb::test;

namespace {

constexpr uint32_t kWidth = 5, kHeight = 3;

std::vector<rhi::Format> formats(bool depth) {
  std::vector<rhi::Format> out;
  for (int i = 1; i < int(rhi::Format::Count); ++i)
    if (rhi::formatInfo(rhi::Format(i)).depth == depth) out.push_back(rhi::Format(i));
  return out;
}

/// Bytes that are a finite value in every format: halves and floats with small exponents.
std::vector<std::byte> pattern(rhi::Format format) {
  const rhi::FormatInfo& info = rhi::formatInfo(format);
  std::vector<std::byte> bytes(size_t(kWidth) * kHeight *
                               rhi::hostTexelBytes(format, rhi::Aspect::Color));
  if (info.kind == rhi::FormatKind::Float || format == rhi::Format::D32Float ||
      format == rhi::Format::D32FloatS8) {
    const bool half = !info.depth && info.texelBytes / info.channels == 2;
    for (size_t i = 0; i < bytes.size() / (half ? 2 : 4); ++i) {
      if (half) {
        const auto value = uint16_t(0x3800 + i * 37);  // 0.5 and up
        std::memcpy(&bytes[i * 2], &value, 2);
      } else {
        const float value = 0.5f + float(i) / 1000.0f;
        std::memcpy(&bytes[i * 4], &value, 4);
      }
    }
    return bytes;
  }
  for (size_t i = 0; i < bytes.size(); ++i) bytes[i] = std::byte(uint8_t(i * 73 + 5));
  const bool depth24 = info.depth && info.texelBytes == 4;
  if (depth24)
    for (size_t i = 3; i < bytes.size(); i += 4) bytes[i] = std::byte(0);
  return bytes;
}

}  // namespace

GPU_TEST(ReadBack, UploadsComeBackUnchangedInEveryColorFormat) {
  int tested = 0;
  for (rhi::Format format : formats(false)) {
    SCOPED_TRACE(rhi::formatInfo(format).name);
    if (!device().formatCaps(format).sampled) continue;
    rhi::Texture texture = texture2D(device(), format, kWidth, kHeight, rhi::TextureUse::Sampled);
    const auto bytes = pattern(format);
    device().upload(texture, {}, bytes);
    EXPECT_EQ(device().read(texture), bytes);
    ++tested;
  }
  EXPECT_GE(tested, 20);
}

GPU_TEST(ReadBack, UploadsComeBackUnchangedInEveryDepthFormat) {
  int tested = 0;
  for (rhi::Format format : formats(true)) {
    SCOPED_TRACE(rhi::formatInfo(format).name);
    if (!device().formatCaps(format).depthTarget) continue;
    rhi::Texture texture = texture2D(device(), format, kWidth, kHeight,
                                     rhi::TextureUse::Sampled | rhi::TextureUse::DepthTarget);
    const auto bytes = pattern(format);
    device().upload(texture, {}, bytes);
    EXPECT_EQ(device().read(texture), bytes);
    ++tested;
  }
  EXPECT_GE(tested, 2);
}

GPU_TEST(ReadBack, ClearsOfEveryColorTargetFormat) {
  for (rhi::Format format : formats(false)) {
    const rhi::FormatInfo& info = rhi::formatInfo(format);
    SCOPED_TRACE(info.name);
    if (!device().formatCaps(format).colorTarget) continue;
    rhi::Texture texture =
        texture2D(device(), format, kWidth, kHeight, rhi::TextureUse::ColorTarget);
    const bool integer = info.kind == rhi::FormatKind::Uint || info.kind == rhi::FormatKind::Sint;
    const bool sint = info.kind == rhi::FormatKind::Sint;
    frame(device(), [&](rhi::CommandList& list) {
      const rhi::ColorAttachment color{
          .view = {.texture = texture},
          .clear = integer ? Vec4{sint ? -3.0f : 3.0f, 5, 7, 9} : Vec4{1, 0, 1, 0}};
      list.beginPass({.label = "clear", .colors = {&color, 1}}).end();
    });
    const auto bytes = device().read(texture);
    // The last texel, channel by channel.
    const size_t channelBytes = info.texelBytes / info.channels;
    if (format == rhi::Format::RGB10A2Unorm) {
      EXPECT_EQ(fromBytes<uint32_t>(bytes).back(), 0x3FFu | 0x3FFu << 20);
      continue;
    }
    for (uint32_t c = 0; c < info.channels; ++c) {
      uint64_t value = 0;
      std::memcpy(&value, &bytes[bytes.size() - info.texelBytes + c * channelBytes], channelBytes);
      uint64_t expected = 0;
      if (integer)
        expected = sint ? uint32_t(-3) : 3 + 2 * c;
      else if (c % 2 == 0)
        expected = info.kind == rhi::FormatKind::Unorm ? (1ull << channelBytes * 8) - 1
                   : channelBytes == 2                 ? 0x3C00
                                                       : std::bit_cast<uint32_t>(1.0f);
      EXPECT_EQ(value, expected) << "channel " << c;
    }
  }
}

GPU_TEST(ReadBack, IntegerClearsSaturate) {
  // The end of every linked list is 0xFFFFFFFF, which as a float is 2^32.
  rhi::Texture texture =
      texture2D(device(), rhi::Format::RG32Uint, 1, 1, rhi::TextureUse::ColorTarget);
  frame(device(), [&](rhi::CommandList& list) {
    const rhi::ColorAttachment color{.view = {.texture = texture},
                                     .clear = {float(0xFFFFFFFFu), -1, 0, 0}};
    list.beginPass({.label = "clear", .colors = {&color, 1}}).end();
  });
  EXPECT_EQ(readTexels<uint32_t>(device(), texture), (std::vector<uint32_t>{0xFFFFFFFFu, 0}));
}

GPU_TEST(ReadBack, DepthAndStencilAspectsAreApart) {
  int tested = 0;
  for (rhi::Format format : formats(true)) {
    const rhi::FormatInfo& info = rhi::formatInfo(format);
    SCOPED_TRACE(info.name);
    if (!device().formatCaps(format).depthTarget) continue;
    rhi::Texture texture =
        texture2D(device(), format, kWidth, kHeight, rhi::TextureUse::DepthTarget);
    auto desc = graphics("fullscreen", "");  // depth 0.5
    desc.depthFormat = format;
    desc.depth = {.test = true, .write = true, .compare = rhi::CompareOp::Always};
    if (info.stencil) {
      desc.stencil.test = true;
      desc.stencil.front.pass = desc.stencil.back.pass = rhi::StencilOp::Replace;
    }
    rhi::Pipeline pipeline = device().createPipeline(desc);
    frame(device(), [&](rhi::CommandList& list) {
      auto pass = list.beginPass(
          {.label = "depth",
           .depth = rhi::DepthAttachment{
               .view = {.texture = texture}, .clearDepth = 1, .clearStencil = 0x5A}});
      list.draw({.pipeline = pipeline, .scissor = rhi::Rect{1, 1, 2, 1}, .stencilReference = 0xC3},
                {.vertexCount = 3});
    });
    const auto bytes = device().read(texture, {}, rhi::Aspect::Depth);
    for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
      const bool drawn = i == kWidth + 1 || i == kWidth + 2;
      double depth = 0;
      if (format == rhi::Format::D16Unorm)
        depth = fromBytes<uint16_t>(bytes)[i] / 65535.0;
      else if (info.texelBytes == 4 && format != rhi::Format::D32Float)
        depth = fromBytes<uint32_t>(bytes)[i] / 16777215.0;
      else
        depth = double(fromBytes<float>(bytes)[i]);
      EXPECT_NEAR(depth, drawn ? 0.5 : 1.0, format == rhi::Format::D16Unorm ? 1e-5 : 1e-7) << i;
      if (!info.stencil) continue;
      EXPECT_EQ(readTexels<uint8_t>(device(), texture, {}, rhi::Aspect::Stencil)[i],
                drawn ? 0xC3 : 0x5A)
          << i;
    }
    ++tested;
  }
  EXPECT_GE(tested, 3);
}

GPU_TEST(ReadBack, PartsOfBuffers) {
  rhi::Buffer buffer = bufferOf(device(), std::vector<uint32_t>{1, 2, 3, 4});
  device().upload(buffer, 4, bytesOf(std::vector<uint32_t>{20, 30}));
  EXPECT_EQ(fromBytes<uint32_t>(device().read(buffer, 4, 12)), (std::vector<uint32_t>{20, 30, 4}));
  EXPECT_EQ(readAll<uint32_t>(device(), buffer), (std::vector<uint32_t>{1, 20, 30, 4}));
}

// Sizes of 2 GiB do not fit the calls of OpenGL: large reads come in parts, this one in two.
GPU_TEST(ReadBack, LargeTexturesComeBackWhole) {
  constexpr uint32_t kSide = 4096, kRows = 4500;
  rhi::Texture texture =
      texture2D(device(), rhi::Format::R32Uint, kSide, kRows, rhi::TextureUse::Sampled);
  std::vector<uint32_t> values(size_t(kSide) * kRows);
  for (size_t i = 0; i < values.size(); ++i) values[i] = uint32_t(i * 2654435761u);
  device().upload(texture, {}, bytesOf(values));
  EXPECT_TRUE(readTexels<uint32_t>(device(), texture) == values);
}
