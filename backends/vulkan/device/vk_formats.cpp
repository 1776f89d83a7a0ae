#include "backends/vulkan/device/vk_formats.h"

namespace vulkan {

VkFormat toVk(rhi::Format format) {
  static constexpr VkFormat kTable[] = {
      VK_FORMAT_UNDEFINED,
      VK_FORMAT_R8_UNORM,
      VK_FORMAT_R8G8_UNORM,
      VK_FORMAT_R8G8B8A8_UNORM,
      VK_FORMAT_R8G8B8A8_SRGB,
      VK_FORMAT_A2B10G10R10_UNORM_PACK32,
      VK_FORMAT_R16_UNORM,
      VK_FORMAT_R16G16_UNORM,
      VK_FORMAT_R16G16B16A16_UNORM,
      VK_FORMAT_R16_SFLOAT,
      VK_FORMAT_R16G16_SFLOAT,
      VK_FORMAT_R16G16B16A16_SFLOAT,
      VK_FORMAT_R32_SFLOAT,
      VK_FORMAT_R32G32_SFLOAT,
      VK_FORMAT_R32G32B32A32_SFLOAT,
      VK_FORMAT_R8_UINT,
      VK_FORMAT_R16_UINT,
      VK_FORMAT_R16G16_UINT,
      VK_FORMAT_R16G16B16A16_UINT,
      VK_FORMAT_R32_UINT,
      VK_FORMAT_R32G32_UINT,
      VK_FORMAT_R32G32B32A32_UINT,
      VK_FORMAT_R32_SINT,
      VK_FORMAT_D16_UNORM,
      VK_FORMAT_X8_D24_UNORM_PACK32,
      VK_FORMAT_D24_UNORM_S8_UINT,
      VK_FORMAT_D32_SFLOAT,
      VK_FORMAT_D32_SFLOAT_S8_UINT,
  };
  static_assert(std::size(kTable) == size_t(rhi::Format::Count));
  return kTable[size_t(format)];
}

VkFormat toVk(rhi::VertexFormat format) {
  static constexpr VkFormat kTable[] = {
      VK_FORMAT_R32_SFLOAT,          VK_FORMAT_R32G32_SFLOAT,  VK_FORMAT_R32G32B32_SFLOAT,
      VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_R32_UINT,       VK_FORMAT_R32G32_UINT,
      VK_FORMAT_R32G32B32A32_UINT,   VK_FORMAT_R8G8B8A8_UNORM,
  };
  return kTable[size_t(format)];
}

VkImageAspectFlags aspectsOf(rhi::Format format) {
  const rhi::FormatInfo& info = rhi::formatInfo(format);
  if (!info.depth) return VK_IMAGE_ASPECT_COLOR_BIT;
  return VK_IMAGE_ASPECT_DEPTH_BIT |
         (info.stencil ? VkImageAspectFlags(VK_IMAGE_ASPECT_STENCIL_BIT) : 0);
}

VkImageAspectFlagBits aspectOf(rhi::Aspect aspect) {
  switch (aspect) {
    case rhi::Aspect::Depth:
      return VK_IMAGE_ASPECT_DEPTH_BIT;
    case rhi::Aspect::Stencil:
      return VK_IMAGE_ASPECT_STENCIL_BIT;
    default:
      return VK_IMAGE_ASPECT_COLOR_BIT;
  }
}

VkImageAspectFlags sampledAspect(rhi::Format format) {
  return rhi::formatInfo(format).depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

rhi::FormatCaps formatCapsOf(VkPhysicalDevice device, rhi::Format format) {
  if (format == rhi::Format::Undefined) return {};
  VkFormatProperties properties;
  vkGetPhysicalDeviceFormatProperties(device, toVk(format), &properties);
  const VkFormatFeatureFlags f = properties.optimalTilingFeatures;
  rhi::FormatCaps caps = {
      .sampled = (f & VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT) != 0,
      .linearFilter = (f & VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT) != 0,
      .colorTarget = (f & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT) != 0,
      .blend = (f & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT) != 0,
      .depthTarget = (f & VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT) != 0,
      .storage = (f & VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT) != 0,
      .storageAtomic = (f & VK_FORMAT_FEATURE_STORAGE_IMAGE_ATOMIC_BIT) != 0,
  };
  const VkImageUsageFlags usage =
      caps.colorTarget   ? VkImageUsageFlags(VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT)
      : caps.depthTarget ? VkImageUsageFlags(VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT)
                         : 0;
  VkImageFormatProperties image;
  if (usage && vkGetPhysicalDeviceImageFormatProperties(device, toVk(format), VK_IMAGE_TYPE_2D,
                                                        VK_IMAGE_TILING_OPTIMAL, usage, 0,
                                                        &image) == VK_SUCCESS)
    for (uint32_t samples = 1; samples <= 64; samples *= 2)
      if (image.sampleCounts & samples) caps.sampleCounts.push_back(samples);
  return caps;
}

}  // namespace vulkan
