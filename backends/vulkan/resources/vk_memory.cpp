#include "backends/vulkan/resources/vk_memory.h"

#include <algorithm>

namespace vulkan {

struct MemoryBlock {
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkDeviceSize size = 0;
  uint32_t type = 0;
  bool image = false;
  bool shared = true;
  std::byte* mapped = nullptr;
  std::map<VkDeviceSize, VkDeviceSize> free;  // offset -> size, never adjacent

  bool cut(VkDeviceSize bytes, VkDeviceSize alignment, VkDeviceSize& offset) {
    for (auto it = free.begin(); it != free.end(); ++it) {
      const auto [begin, length] = *it;
      offset = (begin + alignment - 1) / alignment * alignment;
      if (offset + bytes > begin + length) continue;
      free.erase(it);
      if (offset > begin) free[begin] = offset - begin;
      if (begin + length > offset + bytes) free[offset + bytes] = begin + length - offset - bytes;
      return true;
    }
    return false;
  }

  void giveBack(VkDeviceSize offset, VkDeviceSize bytes) {
    auto next = free.lower_bound(offset);
    if (next != free.end() && next->first == offset + bytes) {
      bytes += next->second;
      next = free.erase(next);
    }
    if (next != free.begin()) {
      auto before = std::prev(next);
      if (before->first + before->second == offset) {
        before->second += bytes;
        return;
      }
    }
    free[offset] = bytes;
  }
};

namespace {
constexpr VkDeviceSize kBlockSize = VkDeviceSize(64) << 20;
constexpr VkDeviceSize kLarge = kBlockSize / 4;
}  // namespace

Memory::Memory(const Context& context) : m_context(context) {}

Memory::~Memory() {
  for (auto& block : m_blocks) m_context.vk.vkFreeMemory(m_context.device, block->memory, nullptr);
}

uint32_t Memory::typeFor(uint32_t typeBits, MemoryKind kind, const std::string& label) const {
  constexpr VkMemoryPropertyFlags kHost =
      VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  const VkMemoryPropertyFlags wanted =
      kind == MemoryKind::Device   ? VkMemoryPropertyFlags(VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT)
      : kind == MemoryKind::Upload ? kHost
                                   : kHost | VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
  const VkMemoryPropertyFlags least = kind == MemoryKind::Device ? 0 : kHost;
  const VkPhysicalDeviceMemoryProperties& memory = m_context.physical().memory;
  for (VkMemoryPropertyFlags flags : {wanted, least})
    for (uint32_t i = 0; i < memory.memoryTypeCount; ++i)
      if ((typeBits >> i & 1) && (memory.memoryTypes[i].propertyFlags & flags) == flags) return i;
  throw rhi::Error("vkAllocateMemory", "", "no memory type fits '" + label + "'");
}

MemoryBlock* Memory::newBlock(VkDeviceSize size, uint32_t type, bool image, bool mapped,
                              const std::string& label) {
  auto block = std::make_unique<MemoryBlock>();
  const VkMemoryAllocateInfo info = {
      .sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
      .allocationSize = size,
      .memoryTypeIndex = type,
  };
  const VkResult result =
      m_context.vk.vkAllocateMemory(m_context.device, &info, nullptr, &block->memory);
  if (result != VK_SUCCESS)
    check(result, "vkAllocateMemory", "'" + label + "', " + std::to_string(size) + " bytes");
  block->size = size;
  block->type = type;
  block->image = image;
  block->free[0] = size;
  m_blocks.push_back(std::move(block));
  MemoryBlock* added = m_blocks.back().get();
  if (mapped) {
    void* pointer = nullptr;
    check(m_context.vk.vkMapMemory(m_context.device, added->memory, 0, VK_WHOLE_SIZE, 0, &pointer),
          "vkMapMemory", label);
    added->mapped = static_cast<std::byte*>(pointer);
  }
  return added;
}

Allocation Memory::allocate(const VkMemoryRequirements& needs, MemoryKind kind, bool image,
                            const std::string& label) {
  const uint32_t type = typeFor(needs.memoryTypeBits, kind, label);
  const bool mapped = kind != MemoryKind::Device;
  MemoryBlock* block = nullptr;
  VkDeviceSize offset = 0;
  if (needs.size < kLarge) {
    for (auto& candidate : m_blocks)
      if (candidate->shared && candidate->type == type && candidate->image == image &&
          (candidate->mapped != nullptr) == mapped &&
          candidate->cut(needs.size, needs.alignment, offset)) {
        block = candidate.get();
        break;
      }
    if (!block) {
      block = newBlock(kBlockSize, type, image, mapped, label);
      block->cut(needs.size, needs.alignment, offset);
    }
  } else {
    block = newBlock(needs.size, type, image, mapped, label);
    block->shared = false;
    block->cut(needs.size, 1, offset);
  }
  return {block, block->memory, offset, needs.size, mapped ? block->mapped + offset : nullptr};
}

void Memory::free(const Allocation& allocation) {
  MemoryBlock* block = allocation.block;
  if (!block) return;
  block->giveBack(allocation.offset, allocation.size);
  // Shared blocks stay for the next resource; only large ones go back to the driver.
  if (block->shared) return;
  m_context.vk.vkFreeMemory(m_context.device, block->memory, nullptr);
  std::erase_if(m_blocks, [&](const auto& b) { return b.get() == block; });
}

}  // namespace vulkan
