// Graphics and compute pipelines (dynamic rendering; viewport, scissor, stencil reference and blend
// constants are dynamic state).
#pragma once

#include "backends/rhi/desc.h"
#include "backends/vulkan/pipeline/vk_pipeline_layout.h"

namespace vulkan {

struct Pipeline {
  std::string label;
  VkPipeline handle = VK_NULL_HANDLE;
  const PipelineLayout* layout = nullptr;
  VkPipelineBindPoint bindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
};

Pipeline createPipeline(const Context& context, PipelineLayouts& layouts,
                        const rhi::GraphicsPipelineDesc& desc);
Pipeline createPipeline(const Context& context, PipelineLayouts& layouts,
                        const rhi::ComputePipelineDesc& desc);

}  // namespace vulkan
