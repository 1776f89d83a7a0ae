#include "backends/vulkan/pipeline/vk_descriptors.h"

#include <algorithm>

#include "backends/rhi/memory_limit.h"
#include "backends/vulkan/device/vk_device.h"
#include "backends/vulkan/device/vk_formats.h"

namespace vulkan {
namespace {

constexpr size_t kManySets = 4096;
constexpr uint64_t kOldFrames = 8;
constexpr uint32_t kSetsPerPool = 128;
/// Blocks are small, and a fixed range keeps sets of different offsets equal.
constexpr uint64_t kUniformWindow = 64 * 1024;

bool isImage(VkDescriptorType type) { return type == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE; }
bool isTexture(VkDescriptorType type) { return type == VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER; }
bool isUniform(VkDescriptorType type) { return type == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC; }

}  // namespace

size_t Descriptors::Hash::operator()(const Key& key) const {
  uint64_t hash = 0xcbf29ce484222325;
  for (uint64_t word : key) {
    hash = (hash ^ word) * 0x9e3779b97f4a7c15;
    hash ^= hash >> 29;
  }
  return size_t(hash);
}

Descriptors::~Descriptors() {
  const Context& c = m_device.context();
  for (VkDescriptorPool pool : m_pools) c.vk.vkDestroyDescriptorPool(c.device, pool, nullptr);
}

uint64_t Descriptors::uniformRange(const rhi::Binding& binding) const {
  if (binding.size != rhi::kWholeSize) return binding.size;
  const uint64_t window = std::min(kUniformWindow, m_device.info().limits.maxUniformRange);
  return std::min(m_device.get(binding.buffer).desc.size - binding.offset, window);
}

void Descriptors::makeKey(const PipelineLayout& layout, const Table& table) {
  m_key.clear();
  m_key.push_back(uint64_t(uintptr_t(&layout)));
  for (const auto& [slot, type] : layout.slots) {
    const rhi::Binding& b = *table[slot];
    if (isTexture(type) || isImage(type)) {
      m_key.push_back(word(kTexture, b.view.texture.value));
      m_key.push_back(uint64_t(b.view.baseMip) << 32 | b.view.mipCount);
      m_key.push_back(uint64_t(b.view.baseLayer) << 32 | b.view.layerCount);
      if (isTexture(type)) m_key.push_back(word(kSampler, b.sampler.value));
    } else {
      m_key.push_back(word(kBuffer, b.buffer.value));
      m_key.push_back(isUniform(type) ? uniformRange(b) : b.size);
      if (!isUniform(type)) m_key.push_back(b.offset);
    }
  }
}

VkDescriptorSet Descriptors::get(const PipelineLayout& layout, const Table& table) {
  makeKey(layout, table);
  auto it = m_sets.find(m_key);
  if (it == m_sets.end()) {
    const Entry entry = allocate(layout);
    try {
      write(entry.set, layout, table);
    } catch (...) {
      release(entry);
      throw;
    }
    it = m_sets.emplace(m_key, entry).first;
  }
  it->second.lastFrame = m_frame;
  return it->second.set;
}

Descriptors::Entry Descriptors::allocate(const PipelineLayout& layout) {
  const Context& c = m_device.context();
  Entry entry;
  VkDescriptorSetAllocateInfo info = {
      .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
      .descriptorSetCount = 1,
      .pSetLayouts = &layout.set,
  };
  for (auto pool = m_pools.rbegin(); pool != m_pools.rend(); ++pool) {
    info.descriptorPool = *pool;
    const VkResult result = c.vk.vkAllocateDescriptorSets(c.device, &info, &entry.set);
    entry.pool = *pool;
    if (result == VK_SUCCESS) return entry;
    if (result != VK_ERROR_OUT_OF_POOL_MEMORY && result != VK_ERROR_FRAGMENTED_POOL)
      check(result, "vkAllocateDescriptorSets");
  }
  const VkDescriptorPoolSize sizes[] = {
      {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC, kSetsPerPool * 8},
      {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, kSetsPerPool * 16},
      {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, kSetsPerPool * 32},
      {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, kSetsPerPool * 8},
  };
  const VkDescriptorPoolCreateInfo poolInfo = {
      .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
      .flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT,
      .maxSets = kSetsPerPool,
      .poolSizeCount = uint32_t(std::size(sizes)),
      .pPoolSizes = sizes,
  };
  check(c.vk.vkCreateDescriptorPool(c.device, &poolInfo, nullptr, &entry.pool),
        "vkCreateDescriptorPool");
  m_pools.push_back(entry.pool);
  info.descriptorPool = entry.pool;
  check(c.vk.vkAllocateDescriptorSets(c.device, &info, &entry.set), "vkAllocateDescriptorSets");
  return entry;
}

void Descriptors::write(VkDescriptorSet set, const PipelineLayout& layout, const Table& table) {
  std::array<VkWriteDescriptorSet, rhi::kSlotCount> writes;
  std::array<VkDescriptorBufferInfo, rhi::kSlotCount> buffers;
  std::array<VkDescriptorImageInfo, rhi::kSlotCount> images;
  uint32_t count = 0;
  for (const auto& [slot, type] : layout.slots) {
    const rhi::Binding& b = *table[slot];
    if (isTexture(type) || isImage(type)) {
      Texture& texture = m_device.get(b.view.texture);
      images[count] = {
          .sampler = isTexture(type) ? m_device.get(b.sampler) : VK_NULL_HANDLE,
          .imageView = viewOf(m_device.context(), texture, texture.resolve(b.view),
                              sampledAspect(texture.desc.format)),
          .imageLayout = isImage(type) ? VK_IMAGE_LAYOUT_GENERAL : texture.restLayout,
      };
    } else {
      const Buffer& buffer = m_device.get(b.buffer);
      const uint64_t offset = isUniform(type) ? 0 : b.offset;
      const uint64_t size = isUniform(type)             ? uniformRange(b)
                            : b.size == rhi::kWholeSize ? buffer.desc.size - b.offset
                                                        : b.size;
      if (!isUniform(type)) rhi::requireStorageRange(m_device.info().limits, buffer.desc.label, size);
      buffers[count] = {buffer.handle, offset, size};
    }
    writes[count] = {
        .sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
        .dstSet = set,
        .dstBinding = slot,
        .descriptorCount = 1,
        .descriptorType = type,
        .pImageInfo = &images[count],
        .pBufferInfo = &buffers[count],
    };
    ++count;
  }
  const Context& c = m_device.context();
  c.vk.vkUpdateDescriptorSets(c.device, count, writes.data(), 0, nullptr);
}

void Descriptors::release(const Entry& entry) {
  m_device.queue().defer([this, entry] {
    const Context& c = m_device.context();
    c.vk.vkFreeDescriptorSets(c.device, entry.pool, 1, &entry.set);
  });
}

void Descriptors::forgetWord(uint64_t word) {
  std::erase_if(m_sets, [&](const auto& item) {
    // The first word is the layout. Another word that happens to be equal costs a set, no more.
    const Key& key = item.first;
    if (std::find(key.begin() + 1, key.end(), word) == key.end()) return false;
    release(item.second);
    return true;
  });
}

void Descriptors::endFrame() {
  ++m_frame;
  if (m_sets.size() <= kManySets) return;
  std::erase_if(m_sets, [&](const auto& item) {
    if (item.second.lastFrame + kOldFrames > m_frame) return false;
    release(item.second);
    return true;
  });
}

}  // namespace vulkan
