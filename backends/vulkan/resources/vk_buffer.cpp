#include "backends/vulkan/resources/vk_buffer.h"

namespace vulkan {

Buffer createBuffer(const Context& context, Memory& memory, const rhi::BufferDesc& desc) {
  using rhi::BufferUse;
  // Uploads, fills and read-back are open to every buffer.
  VkBufferUsageFlags usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  if (has(desc.use, BufferUse::Vertex)) usage |= VK_BUFFER_USAGE_VERTEX_BUFFER_BIT;
  if (has(desc.use, BufferUse::Index)) usage |= VK_BUFFER_USAGE_INDEX_BUFFER_BIT;
  if (has(desc.use, BufferUse::Uniform)) usage |= VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
  if (has(desc.use, BufferUse::Storage)) usage |= VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  if (has(desc.use, BufferUse::Indirect)) usage |= VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;
  Buffer buffer;
  buffer.desc = desc;
  const VkBufferCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
      // Fills and copies go in words, and the last one may reach beyond an odd size.
      .size = (desc.size + 3) & ~uint64_t(3),
      .usage = usage,
  };
  const std::string detail = "'" + desc.label + "', " + std::to_string(desc.size) + " bytes";
  check(context.vk.vkCreateBuffer(context.device, &info, nullptr, &buffer.handle), "vkCreateBuffer",
        detail);
  try {
    VkMemoryRequirements needs;
    context.vk.vkGetBufferMemoryRequirements(context.device, buffer.handle, &needs);
    buffer.allocation = memory.allocate(needs, MemoryKind::Device, false, desc.label);
    check(context.vk.vkBindBufferMemory(context.device, buffer.handle, buffer.allocation.memory,
                                        buffer.allocation.offset),
          "vkBindBufferMemory", detail);
  } catch (...) {
    destroyBuffer(context, memory, buffer);
    throw;
  }
  context.name(buffer.handle, VK_OBJECT_TYPE_BUFFER, desc.label);
  return buffer;
}

void destroyBuffer(const Context& context, Memory& memory, const Buffer& buffer) {
  context.vk.vkDestroyBuffer(context.device, buffer.handle, nullptr);
  memory.free(buffer.allocation);
}

}  // namespace vulkan
