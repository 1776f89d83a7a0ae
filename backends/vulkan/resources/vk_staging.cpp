#include "backends/vulkan/resources/vk_staging.h"

#include <algorithm>

namespace vulkan {
namespace {
constexpr VkDeviceSize kChunkSize = VkDeviceSize(1) << 20;
}  // namespace

Staging::~Staging() {
  for (const Chunk& chunk : m_chunks) destroy(chunk);
}

void Staging::destroy(const Chunk& chunk) {
  m_context.vk.vkDestroyBuffer(m_context.device, chunk.buffer, nullptr);
  m_memory.free(chunk.allocation);
}

void Staging::add(VkDeviceSize size) {
  Chunk chunk;
  chunk.size = std::max(size, kChunkSize);
  const VkBufferCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
      .size = chunk.size,
      .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
  };
  check(m_context.vk.vkCreateBuffer(m_context.device, &info, nullptr, &chunk.buffer),
        "vkCreateBuffer", "staging");
  VkMemoryRequirements needs;
  m_context.vk.vkGetBufferMemoryRequirements(m_context.device, chunk.buffer, &needs);
  try {
    chunk.allocation = m_memory.allocate(needs, m_kind, false, "staging");
  } catch (...) {
    m_context.vk.vkDestroyBuffer(m_context.device, chunk.buffer, nullptr);
    throw;
  }
  m_chunks.push_back(chunk);
  check(m_context.vk.vkBindBufferMemory(m_context.device, chunk.buffer, chunk.allocation.memory,
                                        chunk.allocation.offset),
        "vkBindBufferMemory", "staging");
  m_context.name(chunk.buffer, VK_OBJECT_TYPE_BUFFER, "staging");
}

StagingSpan Staging::take(VkDeviceSize size) {
  auto fits = [&](const Chunk& chunk) { return chunk.used + size <= chunk.size; };
  auto it = std::ranges::find_if(m_chunks, fits);
  if (it == m_chunks.end()) {
    add(size);
    it = std::prev(m_chunks.end());
  }
  const VkDeviceSize offset = it->used;
  it->used = (offset + size + 15) & ~VkDeviceSize(15);
  return {it->buffer, offset, it->allocation.mapped + offset};
}

void Staging::reset() {
  std::erase_if(m_chunks, [&](Chunk& chunk) {
    chunk.used = 0;
    if (chunk.size <= kChunkSize) return false;
    destroy(chunk);
    return true;
  });
}

}  // namespace vulkan
