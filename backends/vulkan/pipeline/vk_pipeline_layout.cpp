#include "backends/vulkan/pipeline/vk_pipeline_layout.h"

namespace vulkan {
namespace {

VkDescriptorType typeOf(rhi::ShaderResourceKind kind) {
  switch (kind) {
    case rhi::ShaderResourceKind::UniformBuffer:
      return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC;
    case rhi::ShaderResourceKind::StorageBuffer:
      return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    case rhi::ShaderResourceKind::Texture:
      return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    default:
      return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
  }
}

}  // namespace

PipelineLayouts::~PipelineLayouts() {
  for (auto& [key, layout] : m_layouts) {
    m_context.vk.vkDestroyPipelineLayout(m_context.device, layout->layout, nullptr);
    m_context.vk.vkDestroyDescriptorSetLayout(m_context.device, layout->set, nullptr);
  }
}

const PipelineLayout& PipelineLayouts::get(std::span<const rhi::ShaderCode* const> stages,
                                           bool compute) {
  std::map<uint32_t, VkDescriptorType> used;
  for (const rhi::ShaderCode* stage : stages)
    if (stage)
      for (const rhi::ShaderResource& resource : stage->resources)
        used[resource.slot] = typeOf(resource.kind);
  Key key = {compute, {}};
  for (auto [slot, type] : used) key.second.push_back({slot, type});
  auto& layout = m_layouts[key];
  if (!layout) layout = create(key.second, compute);
  return *layout;
}

std::unique_ptr<PipelineLayout> PipelineLayouts::create(std::vector<PipelineLayout::Slot> slots,
                                                        bool compute) {
  auto layout = std::make_unique<PipelineLayout>();
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  // All graphics stages alike: more pipelines share a layout, and with it their bound sets.
  const VkShaderStageFlags stages =
      compute ? VK_SHADER_STAGE_COMPUTE_BIT : VK_SHADER_STAGE_ALL_GRAPHICS;
  for (const auto& slot : slots) {
    bindings.push_back({slot.slot, slot.type, 1, stages, nullptr});
    if (slot.type == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC) ++layout->uniformCount;
  }
  const VkDescriptorSetLayoutCreateInfo setInfo = {
      .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
      .bindingCount = uint32_t(bindings.size()),
      .pBindings = bindings.data(),
  };
  check(m_context.vk.vkCreateDescriptorSetLayout(m_context.device, &setInfo, nullptr, &layout->set),
        "vkCreateDescriptorSetLayout");
  const VkPipelineLayoutCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
      .setLayoutCount = 1,
      .pSetLayouts = &layout->set,
  };
  check(m_context.vk.vkCreatePipelineLayout(m_context.device, &info, nullptr, &layout->layout),
        "vkCreatePipelineLayout");
  layout->slots = std::move(slots);
  return layout;
}

}  // namespace vulkan
