// rhi state enumerations as Vulkan's.
#pragma once

#include "backends/rhi/desc.h"
#include "backends/vulkan/device/vk_common.h"

namespace vulkan {

VkCompareOp toVk(rhi::CompareOp op);
VkStencilOp toVk(rhi::StencilOp op);
VkBlendOp toVk(rhi::BlendOp op);
VkBlendFactor toVk(rhi::BlendFactor factor);
VkLogicOp toVk(rhi::LogicOp op);
VkCullModeFlags toVk(rhi::CullMode mode);
VkPrimitiveTopology toVk(rhi::Topology topology);
VkAttachmentLoadOp toVk(rhi::LoadOp op);
VkAttachmentStoreOp toVk(rhi::StoreOp op);
VkFilter toVk(rhi::Filter filter);
VkSamplerAddressMode toVk(rhi::AddressMode mode);
VkShaderStageFlagBits toVk(rhi::ShaderStage stage);

}  // namespace vulkan
