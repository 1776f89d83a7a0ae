// Samplers.
#pragma once

#include "backends/rhi/desc.h"
#include "backends/vulkan/device/vk_context.h"

namespace vulkan {

VkSampler createSampler(const Context& context, const rhi::SamplerDesc& desc);

}  // namespace vulkan
