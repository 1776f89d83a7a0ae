#include "backends/rhi/memory_limit.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <fstream>
#include <string>

#include "backends/rhi/ledger.h"

namespace rhi {
namespace {

/// Of the free memory, for pictures, truths and what drivers keep beside.
constexpr double kShare = 0.9;
/// Smaller allocations are not worth a look at the machine.
constexpr uint64_t kSmall = uint64_t(16) << 20;

std::atomic<int64_t> g_booked = 0;
std::optional<uint64_t> g_pretended;
uint64_t g_limit = UINT64_MAX;

uint64_t numberIn(const char* file) {
  std::ifstream in(file);
  uint64_t value = 0;
  return in >> value ? value : UINT64_MAX;  // "max", or no such file
}

/// Of this machine, or of the container that it is.
uint64_t trulyFree() {
  uint64_t free = UINT64_MAX;
  std::ifstream info("/proc/meminfo");
  for (std::string key; info >> key; info.ignore(256, '\n'))
    if (uint64_t kib = 0; key == "MemAvailable:" && info >> kib) free = kib * 1024;
  const uint64_t most = numberIn("/sys/fs/cgroup/memory.max");
  const uint64_t used = numberIn("/sys/fs/cgroup/memory.current");
  if (most != UINT64_MAX && used != UINT64_MAX) free = std::min(free, most - std::min(most, used));
  return free;
}

uint64_t freeHostMemory() { return g_pretended ? *g_pretended : trulyFree(); }

std::string mib(uint64_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, bytes < 10u << 20 ? "%.1f MiB" : "%.0f MiB",
                double(bytes) / (1 << 20));
  return text;
}

void requireMemory(const DeviceInfo& device, uint64_t live, const std::string& what,
                   uint64_t bytes) {
  if (bytes < kSmall) return;
  auto refuse = [&](uint64_t held, uint64_t most, const std::string& of) {
    throw Error("create", kTooLarge,
                what + " needs " + mib(bytes) + " beside the " + mib(held) + " that " +
                    (device.type == DeviceType::Software ? "software devices hold" : "are held") +
                    ", expected at most " + mib(most) + " of " + of);
  };
  if (device.type != DeviceType::Software) {
    if (device.memoryBytes > 0 && live + bytes > device.memoryBytes)
      refuse(live, device.memoryBytes, "device memory");
    return;
  }
  static const uint64_t freeAtFirst = trulyFree();
  const uint64_t now = freeHostMemory();
  const uint64_t held = uint64_t(std::max<int64_t>(0, g_booked));
  const uint64_t first = uint64_t(kShare * double(g_pretended ? *g_pretended : freeAtFirst));
  if (held + bytes > g_limit) refuse(held, g_limit, "memory (--max-memory)");
  if (held + bytes > first) refuse(held, first, "free memory");
  if (bytes > uint64_t(kShare * double(now)))
    refuse(held, uint64_t(kShare * double(now)), "memory that is free now");
}

}  // namespace

bool isTooLarge(const Error& error) {
  return error.code() == kTooLarge || error.code() == "VK_ERROR_OUT_OF_DEVICE_MEMORY" ||
         error.code() == "VK_ERROR_OUT_OF_HOST_MEMORY" || error.code() == "GL_OUT_OF_MEMORY";
}

std::string whyTooLarge(const Error& error) {
  return kTooLargeWords +
         (error.code() == kTooLarge ? error.detail() : std::string(error.what()));
}

void requireFit(const DeviceInfo& device, uint64_t live, const TextureDesc& desc) {
  const std::string size = std::to_string(desc.width) + "x" + std::to_string(desc.height);
  const std::string what = "'" + desc.label + "' (" + size +
                           (desc.layers > 1 ? ", " + std::to_string(desc.layers) + " layers" : "") +
                           ", " + std::string(formatInfo(desc.format).name) + ")";
  auto refuse = [&](const std::string& most) {
    throw Error("create", kTooLarge, what + ", expected at most " + most);
  };
  const Limits& limits = device.limits;
  if (desc.kind != TextureKind::Tex3D && std::max(desc.width, desc.height) > limits.maxTexture2D)
    refuse(std::to_string(limits.maxTexture2D) + " texels a side");
  if (desc.kind == TextureKind::Tex2DArray && desc.layers > limits.maxTextureLayers)
    refuse(std::to_string(limits.maxTextureLayers) + " layers");
  requireMemory(device, live, what, textureBytes(desc));
}

void requireFit(const DeviceInfo& device, uint64_t live, const BufferDesc& desc) {
  requireMemory(device, live, "'" + desc.label + "'", desc.size);
}

void requireStorageRange(const Limits& limits, const std::string& label, uint64_t bytes) {
  const uint64_t range = limits.maxStorageRange;
  if (range > 0 && bytes > range)
    throw Error("bind", kTooLarge,
                "'" + label + "' has " + mib(bytes) + ", expected at most the " + mib(range) +
                    " that shaders of this device reach in a buffer");
}

uint64_t machineMemory() {
  uint64_t total = UINT64_MAX;
  std::ifstream info("/proc/meminfo");
  for (std::string key; info >> key; info.ignore(256, '\n'))
    if (uint64_t kib = 0; key == "MemTotal:" && info >> kib) total = kib * 1024;
  return std::min(total, numberIn("/sys/fs/cgroup/memory.max"));
}

void limitHostMemory(uint64_t bytes) { g_limit = bytes; }

uint64_t hostMemoryLimit() { return g_limit; }

void bookHostMemory(const DeviceInfo& device, int64_t bytes) {
  if (device.type == DeviceType::Software) g_booked += bytes;
}

void pretendFreeMemory(std::optional<uint64_t> bytes) { g_pretended = bytes; }

}  // namespace rhi
