// Query pools. Every query is reset by the host at creation and, when used again, by a command that
// runs before the frame (passes cannot contain resets).
#pragma once

#include <vector>

#include "backends/rhi/desc.h"
#include "backends/vulkan/device/vk_context.h"

namespace vulkan {

struct QueryPool {
  rhi::QueryPoolDesc desc;
  VkQueryPool handle = VK_NULL_HANDLE;
  std::vector<bool> used;  ///< needs a reset before it is used again
};

QueryPool createQueryPool(const Context& context, const rhi::QueryPoolDesc& desc);

/// Fills `out` with the values of Device::readQueries; throws when a frame is not finished.
void readQueries(const Context& context, const QueryPool& pool, uint32_t first, uint32_t count,
                 std::span<uint64_t> out);

}  // namespace vulkan
