// Descriptor sets by content: the same resources in the same slots give the same set, for as long
// as they live. Offsets of uniform buffers are not content (they are dynamic).
#pragma once

#include <array>
#include <unordered_map>
#include <vector>

#include "backends/rhi/desc.h"
#include "backends/vulkan/pipeline/vk_pipeline_layout.h"

namespace vulkan {

class Device;

class Descriptors {
 public:
  using Table = std::array<const rhi::Binding*, rhi::kSlotCount>;

  explicit Descriptors(Device& device) : m_device(device) {}
  ~Descriptors();
  Descriptors(const Descriptors&) = delete;
  Descriptors& operator=(const Descriptors&) = delete;

  /// `table` has a binding for every slot of the layout.
  VkDescriptorSet get(const PipelineLayout& layout, const Table& table);
  /// Bytes of a uniform buffer that a shader sees.
  uint64_t uniformRange(const rhi::Binding& binding) const;

  /// Sets that refer to the object are dropped (freed when no frame uses them).
  void forget(rhi::BufferId id) { forgetWord(word(kBuffer, id.value)); }
  void forget(rhi::TextureId id) { forgetWord(word(kTexture, id.value)); }
  void forget(rhi::SamplerId id) { forgetWord(word(kSampler, id.value)); }
  /// Once a frame: drops the least used sets when there are too many.
  void endFrame();

 private:
  enum Tag : uint64_t { kBuffer = 1, kTexture, kSampler };
  using Key = std::vector<uint64_t>;
  struct Hash {
    size_t operator()(const Key& key) const;
  };
  struct Entry {
    VkDescriptorSet set = VK_NULL_HANDLE;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    uint64_t lastFrame = 0;
  };
  static uint64_t word(Tag tag, uint32_t id) { return uint64_t(tag) << 32 | id; }
  void forgetWord(uint64_t word);
  void release(const Entry& entry);
  void makeKey(const PipelineLayout& layout, const Table& table);
  Entry allocate(const PipelineLayout& layout);
  void write(VkDescriptorSet set, const PipelineLayout& layout, const Table& table);

  Device& m_device;
  std::vector<VkDescriptorPool> m_pools;
  std::unordered_map<Key, Entry, Hash> m_sets;
  Key m_key;  // kept to spare an allocation per look-up
  uint64_t m_frame = 0;
};

}  // namespace vulkan
