#include "backends/vulkan/commands/vk_command_list.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace vulkan {

void CommandList::begin() {
  m_commands = m_device.queue().commands();
  m_graphics = {};
  m_compute = {};
  m_raster = {};
  m_rendering = false;
}

void CommandList::end() { m_device.barriers().endTransfers(m_commands); }

void CommandList::doWrite(rhi::BufferId id, uint64_t offset, std::span<const std::byte> bytes) {
  Buffer& buffer = m_device.get(id);
  assert(offset + bytes.size() <= buffer.desc.size);
  const StagingSpan staging = m_device.queue().staging().take(bytes.size());
  std::memcpy(staging.mapped, bytes.data(), bytes.size());
  m_device.barriers().beginTransfer(m_commands, &buffer, nullptr);
  const VkBufferCopy copy = {staging.offset, offset, bytes.size()};
  m_vk.vkCmdCopyBuffer(m_commands, staging.buffer, buffer.handle, 1, &copy);
}

void CommandList::doFill(rhi::BufferId id, uint64_t offset, uint64_t size, uint32_t word) {
  Buffer& buffer = m_device.get(id);
  assert(offset + size <= buffer.desc.size);
  if (size == 0) return;
  m_device.barriers().beginTransfer(m_commands, &buffer, nullptr);
  m_vk.vkCmdFillBuffer(m_commands, buffer.handle, offset, size, word);
}

void CommandList::doCopy(rhi::BufferId source, uint64_t sourceOffset, rhi::BufferId target,
                         uint64_t targetOffset, uint64_t size) {
  if (size == 0) return;
  Buffer& from = m_device.get(source);
  Buffer& to = m_device.get(target);
  m_device.barriers().beginTransfer(m_commands, &from, &to);
  const VkBufferCopy copy = {sourceOffset, targetOffset, size};
  m_vk.vkCmdCopyBuffer(m_commands, from.handle, to.handle, 1, &copy);
}

void CommandList::doCopy(const rhi::TextureView& source, const rhi::TextureView& target) {
  Texture& from = m_device.get(source.texture);
  Texture& to = m_device.get(target.texture);
  const ViewRange a = from.resolve(source), b = to.resolve(target);
  assert(a.mipCount == b.mipCount && a.layerCount == b.layerCount);
  Barriers& barriers = m_device.barriers();
  barriers.beginTransfer(m_commands, nullptr, nullptr);
  barriers.toTransfer(m_commands, from, a, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  barriers.toTransfer(m_commands, to, b, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  for (uint32_t i = 0; i < a.mipCount; ++i) {
    const uint32_t mip = a.baseMip + i;
    const VkImageCopy copy = {
        .srcSubresource = {from.aspects, mip, a.baseLayer, a.layerCount},
        .dstSubresource = {to.aspects, b.baseMip + i, b.baseLayer, b.layerCount},
        .extent = {std::max(1u, from.desc.width >> mip), std::max(1u, from.desc.height >> mip),
                   std::max(1u, from.desc.depth >> mip)},
    };
    m_vk.vkCmdCopyImage(m_commands, from.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to.image,
                        VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
  }
  barriers.toRest(m_commands, from, a);
  barriers.toRest(m_commands, to, b);
}

void CommandList::doTimestamp(rhi::QueryPoolId id, uint32_t index) {
  QueryPool& pool = m_device.get(id);
  Barriers& barriers = m_device.barriers();
  barriers.endTransfers(m_commands);
  if (pool.used[index]) m_vk.vkCmdResetQueryPool(m_commands, pool.handle, index, 1);
  pool.used[index] = true;
  barriers.full(m_commands);
  m_vk.vkCmdWriteTimestamp2(m_commands, VK_PIPELINE_STAGE_2_BOTTOM_OF_PIPE_BIT, pool.handle, index);
  barriers.full(m_commands);
}

void CommandList::doBeginQuery(rhi::QueryPoolId id, uint32_t index) {
  QueryPool& pool = m_device.get(id);
  if (pool.used[index])
    m_vk.vkCmdResetQueryPool(m_device.queue().prologue(), pool.handle, index, 1);
  pool.used[index] = true;
  const bool precise = pool.desc.kind == rhi::QueryKind::Occlusion;
  m_vk.vkCmdBeginQuery(m_commands, pool.handle, index, precise ? VK_QUERY_CONTROL_PRECISE_BIT : 0);
}

void CommandList::doEndQuery(rhi::QueryPoolId id, uint32_t index) {
  m_vk.vkCmdEndQuery(m_commands, m_device.get(id).handle, index);
}

}  // namespace vulkan
