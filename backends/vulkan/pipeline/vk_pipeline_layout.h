// Pipeline layouts, shared by all pipelines with the same slots: set 0, whose binding numbers are
// the flat slots of the interface. Uniform buffers are dynamic, so that a set does not depend on
// the offset of a draw's data.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "backends/rhi/shader.h"
#include "backends/vulkan/device/vk_context.h"

namespace vulkan {

struct PipelineLayout {
  struct Slot {
    uint32_t slot = 0;
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC;
    auto operator<=>(const Slot&) const = default;
  };
  std::vector<Slot> slots;  ///< ascending; the uniform ones come first
  uint32_t uniformCount = 0;
  VkDescriptorSetLayout set = VK_NULL_HANDLE;
  VkPipelineLayout layout = VK_NULL_HANDLE;
};

class PipelineLayouts {
 public:
  explicit PipelineLayouts(const Context& context) : m_context(context) {}
  ~PipelineLayouts();
  PipelineLayouts(const PipelineLayouts&) = delete;
  PipelineLayouts& operator=(const PipelineLayouts&) = delete;

  /// The layout for everything the stages use. Lives as long as the device.
  const PipelineLayout& get(std::span<const rhi::ShaderCode* const> stages, bool compute);

 private:
  std::unique_ptr<PipelineLayout> create(std::vector<PipelineLayout::Slot> slots, bool compute);

  const Context& m_context;
  using Key = std::pair<bool, std::vector<PipelineLayout::Slot>>;
  std::map<Key, std::unique_ptr<PipelineLayout>> m_layouts;
};

}  // namespace vulkan
