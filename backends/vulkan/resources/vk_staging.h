// A linear arena of host-visible memory: what a frame's writes, or one upload, pass through.
#pragma once

#include <vector>

#include "backends/vulkan/resources/vk_memory.h"

namespace vulkan {

struct StagingSpan {
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offset = 0;
  std::byte* mapped = nullptr;
};

class Staging {
 public:
  Staging(const Context& context, Memory& memory, MemoryKind kind)
      : m_context(context), m_memory(memory), m_kind(kind) {}
  ~Staging();
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;

  /// 16-byte aligned space, valid until reset.
  StagingSpan take(VkDeviceSize size);
  /// Everything taken is free again: call once the GPU is done with it. Keeps the ordinary chunks
  /// and gives back those that one large transfer needed.
  void reset();

 private:
  struct Chunk {
    VkBuffer buffer = VK_NULL_HANDLE;
    Allocation allocation;
    VkDeviceSize size = 0;
    VkDeviceSize used = 0;
  };
  void add(VkDeviceSize size);
  void destroy(const Chunk& chunk);

  const Context& m_context;
  Memory& m_memory;
  MemoryKind m_kind;
  std::vector<Chunk> m_chunks;
};

}  // namespace vulkan
