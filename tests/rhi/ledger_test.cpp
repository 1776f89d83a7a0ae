// The book of live objects, leaks, the slot map behind ids, and the choice of a device.
#include <gtest/gtest.h>

#include "backends/null/null_backend.h"
#include "backends/rhi/pool.h"

using rhi::DeviceInfo;
using rhi::DeviceType;

TEST(Ledger, CountsBytesByLabel) {
  auto device = null_backend::makeBackend()->open({});
  {
    const rhi::Buffer a = device->createBuffer({.label = "nodes", .size = 100});
    const rhi::Buffer b = device->createBuffer({.label = "nodes", .size = 28});
    const rhi::Texture t = device->createTexture({.label = "map",
                                                  .kind = rhi::TextureKind::Tex2DArray,
                                                  .format = rhi::Format::R32Float,
                                                  .width = 8,
                                                  .height = 4,
                                                  .layers = 3,
                                                  .mips = 2});
    const uint64_t map = (8 * 4 + 4 * 2) * 3 * 4;
    EXPECT_EQ(device->ledger().totalBytes(), 128 + map);
    const std::map<std::string, uint64_t> expected = {{"nodes", 128}, {"map", map}};
    EXPECT_EQ(device->ledger().bytesByLabel(), expected);
    EXPECT_EQ(device->ledger().alive(), 3u);
  }
  EXPECT_EQ(device->ledger().totalBytes(), 0u);
  EXPECT_EQ(device->ledger().describeAlive(), "");
}

TEST(LedgerDeathTest, LeaksAreNamedWhenTheDeviceGoes) {
  auto leak = [] {
    auto device = null_backend::makeBackend()->open({});
    new rhi::Buffer(device->createBuffer({.label = "forgotten", .size = 4}));
    device.reset();
    std::exit(1);
  };
  EXPECT_DEATH_IF_SUPPORTED(leak(), "buffer 'forgotten'");
}

TEST(Pool, StaleIdsAreCaught) {
  rhi::Pool<rhi::BufferTag, int> pool;
  const rhi::BufferId first = pool.add(1), second = pool.add(2);
  EXPECT_EQ(pool.get(first), 1);
  EXPECT_EQ(pool.remove(first), 1);
  EXPECT_FALSE(pool.contains(first));
  const rhi::BufferId third = pool.add(3);
  EXPECT_NE(third, first) << "the slot is used again under another generation";
  EXPECT_FALSE(pool.contains(first));
  EXPECT_EQ(pool.get(third), 3);
  EXPECT_EQ(pool.get(second), 2);
  EXPECT_FALSE(pool.contains({}));
}

namespace {

std::vector<DeviceInfo> machines() {
  return {{.index = 0, .name = "llvmpipe", .type = DeviceType::Software},
          {.index = 1, .name = "Radeon RX", .type = DeviceType::Discrete},
          {.index = 2, .name = "Old Card", .type = DeviceType::Discrete, .unusable = "too old"},
          {.index = 3, .name = "Iris", .type = DeviceType::Integrated}};
}

std::string refusal(const std::vector<DeviceInfo>& devices, std::string_view selector) {
  try {
    rhi::chooseDevice(devices, selector);
  } catch (const rhi::Error& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(ChooseDevice, PrefersDiscreteThenIntegrated) {
  auto devices = machines();
  EXPECT_EQ(rhi::chooseDevice(devices, ""), 1u);
  devices.erase(devices.begin() + 1);
  EXPECT_EQ(rhi::chooseDevice(devices, ""), 2u) << "the unusable one does not count";
}

TEST(ChooseDevice, ByNumberOrPartOfName) {
  EXPECT_EQ(rhi::chooseDevice(machines(), "3"), 3u);
  EXPECT_EQ(rhi::chooseDevice(machines(), "LLVM"), 0u);
}

TEST(ChooseDevice, RefusalsSayWhatThereIs) {
  EXPECT_NE(refusal(machines(), "nvidia").find("Radeon RX"), std::string::npos);
  EXPECT_NE(refusal(machines(), "2").find("too old"), std::string::npos);
  EXPECT_NE(refusal({}, "").find("nothing"), std::string::npos);
}
