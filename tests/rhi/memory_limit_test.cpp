// What does not fit is refused before it is allocated, with its bytes and the limit.
#include "backends/rhi/memory_limit.h"

#include <gtest/gtest.h>

#include "backends/null/null_backend.h"

namespace {

rhi::DeviceInfo discrete(uint64_t memory) {
  rhi::DeviceInfo info;
  info.type = rhi::DeviceType::Discrete;
  info.memoryBytes = memory;
  info.limits.maxTexture2D = 8192;
  info.limits.maxTextureLayers = 4;
  return info;
}

rhi::TextureDesc map(uint32_t size, uint32_t layers = 1) {
  return {.label = "map",
          .kind = rhi::TextureKind::Tex2DArray,
          .format = rhi::Format::RGBA32Float,
          .width = size,
          .height = size,
          .layers = layers};
}

template <class Work>
std::string refusalOf(const Work& work) {
  try {
    work();
  } catch (const rhi::Error& e) {
    EXPECT_TRUE(rhi::isTooLarge(e));
    return rhi::whyTooLarge(e);
  }
  return "";
}

TEST(MemoryLimit, TheSumOfWhatIsAliveMustFitDeviceMemory) {
  const rhi::DeviceInfo info = discrete(uint64_t(2) << 30);
  EXPECT_EQ(refusalOf([&] { rhi::requireFit(info, uint64_t(1) << 30, map(8192)); }), "");
  EXPECT_EQ(refusalOf([&] { rhi::requireFit(info, (uint64_t(1) << 30) + 1, map(8192)); }),
            "too large for this device: 'map' (8192x8192, RGBA32F) needs 1024 MiB beside the "
            "1024 MiB that are held, expected at most 2048 MiB of device memory");
  // Where the driver does not tell, it decides.
  EXPECT_EQ(refusalOf([&] { rhi::requireFit(discrete(0), UINT64_MAX / 2, map(8192)); }), "");
}

TEST(MemoryLimit, SidesAndLayersAreTheDevices) {
  const rhi::DeviceInfo info = discrete(0);
  EXPECT_NE(refusalOf([&] {
              rhi::requireFit(info, 0, map(8193));
            }).find("'map' (8193x8193, RGBA32F), expected at most 8192 texels a side"),
            std::string::npos);
  EXPECT_NE(
      refusalOf([&] { rhi::requireFit(info, 0, map(4, 5)); }).find("expected at most 4 layers"),
      std::string::npos);
}

TEST(MemoryLimit, SoftwareDevicesShareTheMachine) {
  auto one = null_backend::makeBackend()->open({}), two = null_backend::makeBackend()->open({});
  rhi::pretendFreeMemory(uint64_t(100) << 20);  // 90 may be taken
  {
    const rhi::Texture first = one->createTexture(map(1024, 3));  // 48 MiB
    EXPECT_NE(refusalOf([&] { two->createTexture(map(1024, 3)); }).find("beside the 48 MiB"),
              std::string::npos);
    EXPECT_NE(refusalOf([&] {
                two->createBuffer({.label = "b", .size = uint64_t(43) << 20});
              }).find("'b' needs 43 MiB"),
              std::string::npos);
    const rhi::Texture fits = two->createTexture(map(1024, 2));
  }
  // What is gone is free again.
  EXPECT_EQ(refusalOf([&] { two->createTexture(map(1024, 5)); }), "");
  rhi::pretendFreeMemory({});
}

TEST(MemoryLimit, WhatDriversRefuseForWantOfMemoryIsTheSame) {
  for (const char* code : {"GL_OUT_OF_MEMORY", "VK_ERROR_OUT_OF_DEVICE_MEMORY"})
    EXPECT_TRUE(rhi::isTooLarge(rhi::Error("call", code, "")));
  EXPECT_FALSE(rhi::isTooLarge(rhi::Error("call", "VK_ERROR_DEVICE_LOST", "")));
}

}  // namespace
