// Device memory: blocks per memory type that are cut first-fit, and blocks of their own for large
// resources. Buffers and images never share a block, so bufferImageGranularity is met.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "backends/vulkan/device/vk_context.h"

namespace vulkan {

enum class MemoryKind : uint8_t { Device, Upload, Readback };

struct MemoryBlock;

/// A range of a block; `mapped` points at it for host-visible kinds.
struct Allocation {
  MemoryBlock* block = nullptr;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkDeviceSize offset = 0;
  VkDeviceSize size = 0;
  std::byte* mapped = nullptr;
};

class Memory {
 public:
  explicit Memory(const Context& context);
  ~Memory();
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  Allocation allocate(const VkMemoryRequirements& needs, MemoryKind kind, bool image,
                      const std::string& label);
  void free(const Allocation& allocation);

 private:
  uint32_t typeFor(uint32_t typeBits, MemoryKind kind, const std::string& label) const;
  MemoryBlock* newBlock(VkDeviceSize size, uint32_t type, bool image, bool mapped,
                        const std::string& label);

  const Context& m_context;
  std::vector<std::unique_ptr<MemoryBlock>> m_blocks;
};

}  // namespace vulkan
