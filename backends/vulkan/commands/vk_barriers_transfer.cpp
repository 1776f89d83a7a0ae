// Runs of transfers, and what stands between them and everything else.
#include <algorithm>

#include "backends/vulkan/commands/vk_barrier_scopes.h"
#include "backends/vulkan/commands/vk_barriers.h"

namespace vulkan {

void Barriers::beginTransfer(VkCommandBuffer commands, Buffer* first, Buffer* second) {
  initialise(commands);
  const bool touched =
      std::ranges::any_of(m_touched, [&](const Buffer* b) { return b == first || b == second; });
  if (!m_transferring || touched) {
    const VkMemoryBarrier2 barrier =
        m_transferring
            ? memoryBarrier(kTransfer, kTransferAccess, kTransfer, kTransferAccess)
            : memoryBarrier(kAllStages, VK_ACCESS_2_MEMORY_WRITE_BIT, kTransfer, kTransferAccess);
    emit(commands, {&barrier, 1}, {}, {});
    m_touched.clear();
    m_transferring = true;
  }
  for (Buffer* buffer : {first, second})
    if (buffer) {
      m_touched.push_back(buffer);
      remember(*buffer);
      buffer->state = {};
    }
}

void Barriers::endTransfers(VkCommandBuffer commands) {
  if (!m_transferring) return;
  const VkMemoryBarrier2 barrier =
      memoryBarrier(kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                    kAllStages | VK_PIPELINE_STAGE_2_HOST_BIT, kAllAccess);
  emit(commands, {&barrier, 1}, {}, {});
  m_touched.clear();
  m_transferring = false;
}

void Barriers::toTransfer(VkCommandBuffer commands, Texture& texture, const ViewRange& range,
                          VkImageLayout layout) {
  // The parts may rest in different layouts, one barrier each.
  for (uint32_t mip = range.baseMip; mip < range.baseMip + range.mipCount; ++mip)
    for (uint32_t layer = range.baseLayer; layer < range.baseLayer + range.layerCount; ++layer) {
      const Scope scope = {kAllStages, VK_ACCESS_2_MEMORY_WRITE_BIT, kTransfer, kTransferAccess};
      m_images.push_back(
          image(texture, {mip, 1, layer, 1}, scope, texture.state(mip, layer).layout, layout));
    }
  coalesce(m_images);
  emit(commands, {}, {}, m_images);
  m_images.clear();
  for (uint32_t mip = range.baseMip; mip < range.baseMip + range.mipCount; ++mip)
    for (uint32_t layer = range.baseLayer; layer < range.baseLayer + range.layerCount; ++layer) {
      remember(texture, texture.state(mip, layer));
      texture.state(mip, layer) = {};
      texture.state(mip, layer).layout = layout;
    }
}

void Barriers::toRest(VkCommandBuffer commands, Texture& texture, const ViewRange& range) {
  const Scope scope = {kTransfer, kTransferAccess, kAllStages, kAllAccess};
  const VkImageLayout from = texture.state(range.baseMip, range.baseLayer).layout;
  const VkImageMemoryBarrier2 barrier = image(texture, range, scope, from, texture.restLayout);
  emit(commands, {}, {}, {&barrier, 1});
  for (uint32_t mip = range.baseMip; mip < range.baseMip + range.mipCount; ++mip)
    for (uint32_t layer = range.baseLayer; layer < range.baseLayer + range.layerCount; ++layer)
      texture.state(mip, layer).layout = texture.restLayout;
}

void Barriers::full(VkCommandBuffer commands) {
  const VkMemoryBarrier2 barrier = memoryBarrier(kAllStages, kAllAccess, kAllStages, kAllAccess);
  emit(commands, {&barrier, 1}, {}, {});
}

}  // namespace vulkan
