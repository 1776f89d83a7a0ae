// rhi formats as Vulkan's, and what a device can do with them.
#pragma once

#include "backends/rhi/desc.h"
#include "backends/rhi/device_info.h"
#include "backends/vulkan/device/vk_common.h"

namespace vulkan {

VkFormat toVk(rhi::Format format);
VkFormat toVk(rhi::VertexFormat format);
/// All aspects of a format (depth and stencil together).
VkImageAspectFlags aspectsOf(rhi::Format format);
VkImageAspectFlagBits aspectOf(rhi::Aspect aspect);
/// The aspect a shader samples: colour or depth.
VkImageAspectFlags sampledAspect(rhi::Format format);

rhi::FormatCaps formatCapsOf(VkPhysicalDevice device, rhi::Format format);

}  // namespace vulkan
