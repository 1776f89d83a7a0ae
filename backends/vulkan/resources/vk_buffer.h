// Buffers: device-local memory with the synchronization state that vk_barriers keeps.
#pragma once

#include "backends/rhi/desc.h"
#include "backends/vulkan/resources/vk_memory.h"

namespace vulkan {

/// How a buffer or a part of an image was last touched. `tracked` becomes true when a pass writes
/// it: from then on every touch is declared; before, passes may have read it without a word.
struct AccessState {
  VkPipelineStageFlags2 writeStages = 0;
  VkAccessFlags2 writeAccess = 0;
  VkPipelineStageFlags2 readStages = 0;     ///< since that write
  VkPipelineStageFlags2 visibleStages = 0;  ///< the write is visible to these with
  VkAccessFlags2 visibleAccess = 0;         ///< these accesses
  bool tracked = false;
  uint32_t batch = 0;  ///< of vk_barriers: the last batch that wanted it, and where
  uint32_t want = 0;
};

struct Buffer {
  rhi::BufferDesc desc;
  VkBuffer handle = VK_NULL_HANDLE;
  Allocation allocation;
  AccessState state;
};

Buffer createBuffer(const Context& context, Memory& memory, const rhi::BufferDesc& desc);
void destroyBuffer(const Context& context, Memory& memory, const Buffer& buffer);

}  // namespace vulkan
