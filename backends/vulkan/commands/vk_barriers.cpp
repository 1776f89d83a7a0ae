#include "backends/vulkan/commands/vk_barriers.h"

#include "backends/vulkan/commands/vk_barrier_scopes.h"

namespace vulkan {
namespace {

bool sameButRange(const VkImageMemoryBarrier2& a, const VkImageMemoryBarrier2& b) {
  return a.image == b.image && a.oldLayout == b.oldLayout && a.newLayout == b.newLayout &&
         a.srcStageMask == b.srcStageMask && a.srcAccessMask == b.srcAccessMask &&
         a.dstStageMask == b.dstStageMask && a.dstAccessMask == b.dstAccessMask;
}

}  // namespace

void coalesce(std::vector<VkImageMemoryBarrier2>& barriers) {
  size_t kept = 0;
  for (size_t i = 1; i < barriers.size(); ++i) {
    VkImageSubresourceRange& last = barriers[kept].subresourceRange;
    const VkImageSubresourceRange& next = barriers[i].subresourceRange;
    const bool same = sameButRange(barriers[kept], barriers[i]);
    if (same && next.baseMipLevel == last.baseMipLevel && next.levelCount == last.levelCount &&
        next.baseArrayLayer == last.baseArrayLayer + last.layerCount)
      last.layerCount += next.layerCount;
    else if (same && next.baseArrayLayer == last.baseArrayLayer &&
             next.layerCount == last.layerCount &&
             next.baseMipLevel == last.baseMipLevel + last.levelCount)
      last.levelCount += next.levelCount;
    else
      barriers[++kept] = barriers[i];
  }
  if (!barriers.empty()) barriers.resize(kept + 1);
}

void Barriers::add(AccessState& state, const Want& want) {
  if (state.batch == m_batch) {
    Want& earlier = m_wants[state.want];
    earlier.stages |= want.stages;
    earlier.access |= want.access;
    earlier.write |= want.write;
    earlier.discard &= want.discard;
    return;
  }
  state.batch = m_batch;
  state.want = uint32_t(m_wants.size());
  m_wants.push_back(want);
}

void Barriers::want(Buffer& buffer, VkPipelineStageFlags2 stages, VkAccessFlags2 access,
                    bool write) {
  add(buffer.state, {.buffer = &buffer, .stages = stages, .access = access, .write = write});
}

void Barriers::want(Texture& texture, const ViewRange& range, VkPipelineStageFlags2 stages,
                    VkAccessFlags2 access, bool write, VkImageLayout layout, bool discard) {
  for (uint32_t mip = range.baseMip; mip < range.baseMip + range.mipCount; ++mip)
    for (uint32_t layer = range.baseLayer; layer < range.baseLayer + range.layerCount; ++layer)
      add(texture.state(mip, layer), {.texture = &texture,
                                      .mip = mip,
                                      .layer = layer,
                                      .stages = stages,
                                      .access = access,
                                      .layout = layout,
                                      .write = write,
                                      .discard = discard});
}

bool Barriers::plan(AccessState& s, const Want& want, bool layoutChanges, Scope& scope) {
  if (want.write || layoutChanges) {
    // Before the first pass that writes it, any pass may have read it undeclared.
    scope = {s.tracked ? s.writeStages | s.readStages : kAllStages,
             s.tracked ? s.writeAccess : VkAccessFlags2(VK_ACCESS_2_MEMORY_WRITE_BIT), want.stages,
             want.access};
    // A layout change counts as a write that is visible to the stages it was made for.
    s.writeStages = want.stages;
    s.writeAccess = want.write ? want.access : 0;
    s.readStages = want.write ? 0 : want.stages;
    s.visibleStages = want.write ? 0 : want.stages;
    s.visibleAccess = want.write ? 0 : want.access;
    s.tracked |= want.write;
    return true;
  }
  s.readStages |= want.stages;
  const bool visible = !(want.stages & ~s.visibleStages) && !(want.access & ~s.visibleAccess);
  if (!s.writeStages || visible) return false;
  // The union, so that every stage sees every access from here on.
  s.visibleStages |= want.stages;
  s.visibleAccess |= want.access;
  scope = {s.writeStages, s.writeAccess, s.visibleStages, s.visibleAccess};
  return true;
}

VkImageMemoryBarrier2 Barriers::image(const Texture& texture, const ViewRange& range,
                                      const Scope& scope, VkImageLayout from, VkImageLayout to) {
  return {
      .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
      .srcStageMask = scope.sourceStages,
      .srcAccessMask = scope.sourceAccess,
      .dstStageMask = scope.stages,
      .dstAccessMask = scope.access,
      .oldLayout = from,
      .newLayout = to,
      .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
      .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
      .image = texture.image,
      .subresourceRange = {texture.aspects, range.baseMip, range.mipCount, range.baseLayer,
                           range.layerCount},
  };
}

void Barriers::append(const Want& want, const Scope& scope, VkImageLayout from) {
  if (want.texture) {
    m_images.push_back(
        image(*want.texture, {want.mip, 1, want.layer, 1}, scope, from, want.layout));
    return;
  }
  m_buffers.push_back({
      .sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2,
      .srcStageMask = scope.sourceStages,
      .srcAccessMask = scope.sourceAccess,
      .dstStageMask = scope.stages,
      .dstAccessMask = scope.access,
      .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
      .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
      .buffer = want.buffer->handle,
      .size = VK_WHOLE_SIZE,
  });
}

void Barriers::flush(VkCommandBuffer commands) {
  initialise(commands);
  for (const Want& want : m_wants) {
    Scope scope;
    if (!want.texture) {
      remember(*want.buffer);
      if (plan(want.buffer->state, want, false, scope)) append(want, scope, {});
      continue;
    }
    SubresourceState& state = want.texture->state(want.mip, want.layer);
    remember(*want.texture, state);
    const VkImageLayout from = state.layout;
    const bool changes = from != want.layout;
    if (!plan(state, want, changes, scope)) continue;
    append(want, scope, want.discard && changes ? VK_IMAGE_LAYOUT_UNDEFINED : from);
    state.layout = want.layout;
  }
  coalesce(m_images);
  emit(commands, {}, m_buffers, m_images);
  m_wants.clear();
  m_buffers.clear();
  m_images.clear();
  ++m_batch;
}

void Barriers::initialise(VkCommandBuffer commands) {
  if (m_new.empty()) return;
  const Scope scope = {0, 0, kAllStages, kAllAccess};
  std::vector<VkImageMemoryBarrier2> images;
  for (Texture* texture : m_new) {
    images.push_back(image(*texture, {0, texture->desc.mips, 0, texture->desc.layers}, scope,
                           VK_IMAGE_LAYOUT_UNDEFINED, texture->restLayout));
    for (SubresourceState& state : texture->states) state.layout = texture->restLayout;
  }
  if (m_inFrame) m_initialised.insert(m_initialised.end(), m_new.begin(), m_new.end());
  m_new.clear();
  emit(commands, {}, {}, images);
}

void Barriers::emit(VkCommandBuffer commands, std::span<const VkMemoryBarrier2> memory,
                    std::span<const VkBufferMemoryBarrier2> buffers,
                    std::span<const VkImageMemoryBarrier2> images) {
  if (memory.empty() && buffers.empty() && images.empty()) return;
  const VkDependencyInfo info = {
      .sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
      .memoryBarrierCount = uint32_t(memory.size()),
      .pMemoryBarriers = memory.data(),
      .bufferMemoryBarrierCount = uint32_t(buffers.size()),
      .pBufferMemoryBarriers = buffers.data(),
      .imageMemoryBarrierCount = uint32_t(images.size()),
      .pImageMemoryBarriers = images.data(),
  };
  m_context.vk.vkCmdPipelineBarrier2(commands, &info);
}

}  // namespace vulkan
