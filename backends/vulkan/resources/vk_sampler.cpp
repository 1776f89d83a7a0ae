#include "backends/vulkan/resources/vk_sampler.h"

#include "backends/vulkan/device/vk_enums.h"

namespace vulkan {

VkSampler createSampler(const Context& context, const rhi::SamplerDesc& desc) {
  const VkSamplerCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
      .magFilter = toVk(desc.filter),
      .minFilter = toVk(desc.filter),
      .mipmapMode = desc.mipFilter == rhi::Filter::Linear ? VK_SAMPLER_MIPMAP_MODE_LINEAR
                                                          : VK_SAMPLER_MIPMAP_MODE_NEAREST,
      .addressModeU = toVk(desc.addressU),
      .addressModeV = toVk(desc.addressV),
      .addressModeW = toVk(desc.addressW),
      .compareEnable = desc.compare.has_value(),
      .compareOp = toVk(desc.compare.value_or(rhi::CompareOp::Always)),
      .maxLod = desc.maxLod,
      .borderColor = desc.border == rhi::BorderColor::OpaqueWhite
                         ? VK_BORDER_COLOR_FLOAT_OPAQUE_WHITE
                         : VK_BORDER_COLOR_FLOAT_TRANSPARENT_BLACK,
  };
  VkSampler sampler = VK_NULL_HANDLE;
  check(context.vk.vkCreateSampler(context.device, &info, nullptr, &sampler), "vkCreateSampler",
        desc.label);
  context.name(sampler, VK_OBJECT_TYPE_SAMPLER, desc.label);
  return sampler;
}

}  // namespace vulkan
