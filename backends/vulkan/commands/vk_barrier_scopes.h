// Scopes that barriers of passes and of transfers share.
#pragma once

#include <vector>

#include "backends/vulkan/device/vk_common.h"

namespace vulkan {

inline constexpr VkPipelineStageFlags2 kAllStages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
inline constexpr VkAccessFlags2 kAllAccess =
    VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
inline constexpr VkPipelineStageFlags2 kTransfer = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
inline constexpr VkAccessFlags2 kTransferAccess =
    VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT;

inline VkMemoryBarrier2 memoryBarrier(VkPipelineStageFlags2 from, VkAccessFlags2 fromAccess,
                                      VkPipelineStageFlags2 to, VkAccessFlags2 toAccess) {
  return {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2,
          .srcStageMask = from,
          .srcAccessMask = fromAccess,
          .dstStageMask = to,
          .dstAccessMask = toAccess};
}

/// Barriers come layer by layer within a mip: first layers join, then mips of equal layers.
void coalesce(std::vector<VkImageMemoryBarrier2>& barriers);

}  // namespace vulkan
