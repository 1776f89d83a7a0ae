// Blocking uploads and read-backs outside frames.
#include <algorithm>
#include <cassert>
#include <cstring>

#include "backends/vulkan/device/vk_device.h"
#include "backends/vulkan/device/vk_formats.h"

namespace vulkan {
namespace {

VkBufferImageCopy copyOf(const Texture& texture, const rhi::TextureRegion& region,
                         VkImageAspectFlags aspect, VkDeviceSize offset) {
  const bool volume = texture.desc.kind == rhi::TextureKind::Tex3D;
  return {
      .bufferOffset = offset,
      .imageSubresource = {aspect, region.mip, volume ? 0 : region.layer, 1},
      .imageOffset = {int32_t(region.x), int32_t(region.y), volume ? int32_t(region.layer) : 0},
      .imageExtent = {region.width, region.height, 1},
  };
}

ViewRange rangeOf(const Texture& texture, const rhi::TextureRegion& region) {
  const bool volume = texture.desc.kind == rhi::TextureKind::Tex3D;
  return {region.mip, 1, volume ? 0 : region.layer, 1};
}

}  // namespace

void Device::doUpload(rhi::BufferId id, uint64_t offset, std::span<const std::byte> bytes) {
  Buffer& buffer = m_buffers.get(id);
  assert(offset + bytes.size() <= buffer.desc.size);
  m_uploads.reset();
  const StagingSpan staging = m_uploads.take(bytes.size());
  std::memcpy(staging.mapped, bytes.data(), bytes.size());
  m_queue.immediate([&](VkCommandBuffer commands) {
    m_barriers.beginTransfer(commands, &buffer, nullptr);
    const VkBufferCopy copy = {staging.offset, offset, bytes.size()};
    m_context.vk.vkCmdCopyBuffer(commands, staging.buffer, buffer.handle, 1, &copy);
    m_barriers.endTransfers(commands);
  });
}

void Device::doUpload(rhi::TextureId id, const rhi::TextureRegion& region,
                      std::span<const std::byte> bytes) {
  Texture& texture = m_textures.get(id);
  assert(texture.desc.samples == 1 && "multisampled textures cannot be uploaded");
  m_uploads.reset();
  const StagingSpan staging = m_uploads.take(bytes.size());
  std::memcpy(staging.mapped, bytes.data(), bytes.size());
  const VkBufferImageCopy copy =
      copyOf(texture, region, sampledAspect(texture.desc.format), staging.offset);
  m_queue.immediate([&](VkCommandBuffer commands) {
    m_barriers.beginTransfer(commands, nullptr, nullptr);
    const ViewRange range = rangeOf(texture, region);
    m_barriers.toTransfer(commands, texture, range, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    m_context.vk.vkCmdCopyBufferToImage(commands, staging.buffer, texture.image,
                                        VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
    m_barriers.toRest(commands, texture, range);
    m_barriers.endTransfers(commands);
  });
}

void Device::doRead(rhi::BufferId id, uint64_t offset, std::span<std::byte> out) {
  Buffer& buffer = m_buffers.get(id);
  assert(offset + out.size() <= buffer.desc.size);
  if (out.empty()) return;
  m_readbacks.reset();
  const StagingSpan staging = m_readbacks.take(out.size());
  m_queue.immediate([&](VkCommandBuffer commands) {
    m_barriers.beginTransfer(commands, &buffer, nullptr);
    const VkBufferCopy copy = {offset, staging.offset, out.size()};
    m_context.vk.vkCmdCopyBuffer(commands, buffer.handle, staging.buffer, 1, &copy);
    m_barriers.endTransfers(commands);
  });
  std::memcpy(out.data(), staging.mapped, out.size());
}

void Device::doRead(rhi::TextureId id, const rhi::TextureRegion& region, rhi::Aspect aspect,
                    std::span<std::byte> out) {
  Texture& texture = m_textures.get(id);
  assert(texture.desc.samples == 1 && "resolve a multisampled texture before reading it");
  m_readbacks.reset();
  const StagingSpan staging = m_readbacks.take(out.size());
  const VkBufferImageCopy copy = copyOf(texture, region, aspectOf(aspect), staging.offset);
  m_queue.immediate([&](VkCommandBuffer commands) {
    m_barriers.beginTransfer(commands, nullptr, nullptr);
    const ViewRange range = rangeOf(texture, region);
    m_barriers.toTransfer(commands, texture, range, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    m_context.vk.vkCmdCopyImageToBuffer(
        commands, texture.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, staging.buffer, 1, &copy);
    m_barriers.toRest(commands, texture, range);
    m_barriers.endTransfers(commands);
  });
  std::memcpy(out.data(), staging.mapped, out.size());
  const rhi::Format format = texture.desc.format;
  if (aspect != rhi::Aspect::Depth ||
      (format != rhi::Format::D24Unorm && format != rhi::Format::D24UnormS8))
    return;
  // The upper byte of a copied 24-bit depth is undefined.
  for (size_t i = 3; i < out.size(); i += 4) out[i] = std::byte(0);
}

}  // namespace vulkan
