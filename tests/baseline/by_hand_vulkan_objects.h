// What the frame by hand draws with: the captured buffers, textures and pipelines on a device of
// its own, and a descriptor set for each pipeline of a pass.
#pragma once

#include "backends/vulkan/pipeline/vk_pipeline.h"
#include "backends/vulkan/resources/vk_memory.h"
#include "tests/baseline/by_hand.h"

namespace sb::baseline {

class Objects {
 public:
  /// The first device, and on it everything of the capture, which must outlive this.
  explicit Objects(const Capture& capture);
  /// Waits until the device is idle.
  ~Objects();
  Objects(const Objects&) = delete;

  struct Image {
    VkImage handle = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
  };
  /// What a draw binds.
  struct Set {
    VkDescriptorSet set = VK_NULL_HANDLE;
    std::vector<uint32_t> offsets;
    bool operator==(const Set&) const = default;
  };
  /// A buffer with these bytes, or one to read back from.
  VkBuffer createBuffer(const rhi::BufferDesc& desc, const std::vector<std::byte>* bytes,
                        std::byte** mapped = nullptr);

  const Capture& capture;
  std::unique_ptr<vulkan::Context> context;
  const VolkDeviceTable& vk;
  IdMap<rhi::BufferId, VkBuffer> buffers;
  IdMap<rhi::TextureId, Image> images;
  IdMap<rhi::PipelineId, vulkan::Pipeline> pipelines;
  std::vector<std::vector<Set>> sets;  ///< by pass and draw

 private:
  Image createImage(const rhi::TextureDesc& desc);
  VkSampler createSampler();
  void createSets();
  VkDescriptorSet createSet(const CapturedDraw& draw);

  std::unique_ptr<vulkan::Memory> m_memory;
  std::unique_ptr<vulkan::PipelineLayouts> m_layouts;
  IdMap<rhi::SamplerId, VkSampler> m_samplers;
  VkDescriptorPool m_descriptors = VK_NULL_HANDLE;
};

}  // namespace sb::baseline
