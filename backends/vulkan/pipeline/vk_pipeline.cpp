#include "backends/vulkan/pipeline/vk_pipeline.h"

#include <algorithm>

#include "backends/vulkan/device/vk_enums.h"
#include "backends/vulkan/device/vk_formats.h"
#include "backends/vulkan/pipeline/vk_lavapipe_blocks.h"

namespace vulkan {
namespace {

/// The stages of one pipeline with their modules and constants; modules go away with it.
class Stages {
 public:
  Stages(const Context& context, const std::string& label,
         std::span<const rhi::ShaderCode* const> codes,
         std::span<const rhi::SpecConstant> constants)
      : m_context(context) {
    for (const rhi::SpecConstant& constant : constants)
      if (std::ranges::none_of(codes,
                               [&](auto* code) { return code && declares(*code, constant); }))
        throw rhi::Error("createPipeline", "",
                         "'" + label + "': no stage declares specialization constant " +
                             std::to_string(constant.id));
    m_modules.reserve(codes.size());
    m_constants.reserve(codes.size());
    m_infos.reserve(codes.size());
    try {
      for (const rhi::ShaderCode* code : codes)
        if (code) add(*code, constants);
    } catch (...) {
      destroy();
      throw;
    }
  }
  ~Stages() { destroy(); }
  Stages(const Stages&) = delete;
  Stages& operator=(const Stages&) = delete;

  const std::vector<VkPipelineShaderStageCreateInfo>& infos() const { return m_infos; }

 private:
  struct Constants {
    std::vector<VkSpecializationMapEntry> entries;
    std::vector<uint32_t> bits;
    VkSpecializationInfo info = {};
  };

  static bool declares(const rhi::ShaderCode& code, const rhi::SpecConstant& constant) {
    return std::ranges::any_of(code.constants, [&](auto& c) { return c.id == constant.id; });
  }

  void add(const rhi::ShaderCode& code, std::span<const rhi::SpecConstant> constants) {
    const std::vector<uint32_t> spirv = m_context.physical().isLavapipe
                                            ? indexUniformBlocks(code.spirv, code.stage)
                                            : code.spirv;
    const VkShaderModuleCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
        .codeSize = spirv.size() * sizeof(uint32_t),
        .pCode = spirv.data(),
    };
    VkShaderModule module = VK_NULL_HANDLE;
    check(m_context.vk.vkCreateShaderModule(m_context.device, &info, nullptr, &module),
          "vkCreateShaderModule", code.name);
    m_modules.push_back(module);
    m_context.name(module, VK_OBJECT_TYPE_SHADER_MODULE, code.name);
    Constants& own = m_constants.emplace_back();
    for (const rhi::SpecConstant& constant : constants)
      if (declares(code, constant)) {
        own.entries.push_back({constant.id, uint32_t(own.bits.size() * 4), 4});
        own.bits.push_back(constant.bits);
      }
    own.info = {uint32_t(own.entries.size()), own.entries.data(), own.bits.size() * 4,
                own.bits.data()};
    m_infos.push_back({
        .sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
        .stage = toVk(code.stage),
        .module = module,
        .pName = "main",
        .pSpecializationInfo = own.entries.empty() ? nullptr : &own.info,
    });
  }

  void destroy() {
    for (VkShaderModule module : m_modules)
      m_context.vk.vkDestroyShaderModule(m_context.device, module, nullptr);
    m_modules.clear();
  }

  const Context& m_context;
  std::vector<VkShaderModule> m_modules;
  std::vector<Constants> m_constants;
  std::vector<VkPipelineShaderStageCreateInfo> m_infos;
};

bool usesSecondSource(const rhi::BlendState& blend) {
  using F = rhi::BlendFactor;
  return blend.enabled &&
         std::ranges::any_of(
             std::array{blend.srcColor, blend.dstColor, blend.srcAlpha, blend.dstAlpha},
             [](F f) { return f >= F::Src1Color && f <= F::OneMinusSrc1Alpha; });
}

VkPipelineColorBlendAttachmentState blendOf(const rhi::ColorTargetState& target) {
  const rhi::BlendState& blend = target.blend;
  return {
      .blendEnable = blend.enabled,
      .srcColorBlendFactor = toVk(blend.srcColor),
      .dstColorBlendFactor = toVk(blend.dstColor),
      .colorBlendOp = toVk(blend.colorOp),
      .srcAlphaBlendFactor = toVk(blend.srcAlpha),
      .dstAlphaBlendFactor = toVk(blend.dstAlpha),
      .alphaBlendOp = toVk(blend.alphaOp),
      .colorWriteMask = target.writeMask,
  };
}

VkStencilOpState faceOf(const rhi::StencilFace& face, const rhi::StencilState& stencil) {
  return {
      .failOp = toVk(face.fail),
      .passOp = toVk(face.pass),
      .depthFailOp = toVk(face.depthFail),
      .compareOp = toVk(face.compare),
      .compareMask = stencil.readMask,
      .writeMask = stencil.writeMask,
  };
}

void requireFeatures(const Context& context, const rhi::GraphicsPipelineDesc& desc) {
  const VkPhysicalDeviceFeatures& have = context.features();
  auto require = [&](bool needed, bool present, rhi::Feature feature) {
    if (needed && !present)
      throw rhi::Error("createPipeline", "VK_ERROR_FEATURE_NOT_PRESENT",
                       "'" + desc.label + "' needs " + std::string(rhi::featureName(feature)));
  };
  require(desc.geometry != nullptr, have.geometryShader, rhi::Feature::GeometryShader);
  require(desc.raster.depthClamp, have.depthClamp, rhi::Feature::DepthClamp);
  require(desc.logicOp.has_value(), have.logicOp, rhi::Feature::LogicOp);
  require(desc.sampleShading, have.sampleRateShading, rhi::Feature::SampleRateShading);
  for (const rhi::ColorTargetState& target : desc.targets) {
    require(usesSecondSource(target.blend), have.dualSrcBlend, rhi::Feature::DualSourceBlend);
    const auto a = blendOf(target), b = blendOf(desc.targets[0]);
    const bool same = a.blendEnable == b.blendEnable && a.colorWriteMask == b.colorWriteMask &&
                      a.srcColorBlendFactor == b.srcColorBlendFactor &&
                      a.dstColorBlendFactor == b.dstColorBlendFactor &&
                      a.colorBlendOp == b.colorBlendOp && a.alphaBlendOp == b.alphaBlendOp &&
                      a.srcAlphaBlendFactor == b.srcAlphaBlendFactor &&
                      a.dstAlphaBlendFactor == b.dstAlphaBlendFactor;
    require(!same, have.independentBlend, rhi::Feature::IndependentBlend);
  }
}

}  // namespace

Pipeline createPipeline(const Context& context, PipelineLayouts& layouts,
                        const rhi::GraphicsPipelineDesc& desc) {
  requireFeatures(context, desc);
  const rhi::ShaderCode* codes[] = {desc.vertex, desc.geometry, desc.fragment};
  const Stages stages(context, desc.label, codes, desc.constants);
  Pipeline pipeline = {.label = desc.label, .layout = &layouts.get(codes, false)};

  std::vector<VkVertexInputBindingDescription> buffers;
  for (const auto& b : desc.vertexBuffers)
    buffers.push_back(
        {uint32_t(buffers.size()), b.stride,
         b.perInstance ? VK_VERTEX_INPUT_RATE_INSTANCE : VK_VERTEX_INPUT_RATE_VERTEX});
  std::vector<VkVertexInputAttributeDescription> attributes;
  for (const auto& a : desc.attributes)
    attributes.push_back({a.location, a.buffer, toVk(a.format), a.offset});
  const VkPipelineVertexInputStateCreateInfo vertexInput = {
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
      .vertexBindingDescriptionCount = uint32_t(buffers.size()),
      .pVertexBindingDescriptions = buffers.data(),
      .vertexAttributeDescriptionCount = uint32_t(attributes.size()),
      .pVertexAttributeDescriptions = attributes.data(),
  };
  const VkPipelineInputAssemblyStateCreateInfo assembly = {
      .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
      .topology = toVk(desc.topology),
  };
  const VkPipelineViewportStateCreateInfo viewport = {
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
      .viewportCount = 1,
      .scissorCount = 1,
  };
  // Counter-clockwise with y up in clip space is clockwise by Vulkan's rule, whose framebuffer has
  // y down: the viewport does not flip, the sign convention of the area does.
  const VkPipelineRasterizationStateCreateInfo raster = {
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
      .depthClampEnable = desc.raster.depthClamp,
      .polygonMode = VK_POLYGON_MODE_FILL,
      .cullMode = toVk(desc.raster.cull),
      .frontFace = VK_FRONT_FACE_CLOCKWISE,
      .depthBiasEnable = desc.raster.depthBiasConstant != 0 || desc.raster.depthBiasSlope != 0,
      .depthBiasConstantFactor = desc.raster.depthBiasConstant,
      .depthBiasSlopeFactor = desc.raster.depthBiasSlope,
      .lineWidth = 1,
  };
  const VkPipelineMultisampleStateCreateInfo samples = {
      .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
      .rasterizationSamples = VkSampleCountFlagBits(desc.samples),
      .sampleShadingEnable = desc.sampleShading,
      .minSampleShading = 1,
  };
  const VkPipelineDepthStencilStateCreateInfo depthStencil = {
      .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
      .depthTestEnable = desc.depth.test,
      .depthWriteEnable = desc.depth.test && desc.depth.write,
      .depthCompareOp = toVk(desc.depth.compare),
      .stencilTestEnable = desc.stencil.test,
      .front = faceOf(desc.stencil.front, desc.stencil),
      .back = faceOf(desc.stencil.back, desc.stencil),
      .maxDepthBounds = 1,
  };
  std::vector<VkPipelineColorBlendAttachmentState> blends;
  std::vector<VkFormat> formats;
  for (const rhi::ColorTargetState& target : desc.targets) {
    blends.push_back(blendOf(target));
    formats.push_back(toVk(target.format));
  }
  const VkPipelineColorBlendStateCreateInfo blend = {
      .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
      .logicOpEnable = desc.logicOp.has_value(),
      .logicOp = toVk(desc.logicOp.value_or(rhi::LogicOp::Copy)),
      .attachmentCount = uint32_t(blends.size()),
      .pAttachments = blends.data(),
  };
  const VkDynamicState dynamics[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                     VK_DYNAMIC_STATE_STENCIL_REFERENCE,
                                     VK_DYNAMIC_STATE_BLEND_CONSTANTS};
  const VkPipelineDynamicStateCreateInfo dynamic = {
      .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
      .dynamicStateCount = uint32_t(std::size(dynamics)),
      .pDynamicStates = dynamics,
  };
  const bool stencil = rhi::formatInfo(desc.depthFormat).stencil;
  const VkPipelineRenderingCreateInfo rendering = {
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
      .colorAttachmentCount = uint32_t(formats.size()),
      .pColorAttachmentFormats = formats.data(),
      .depthAttachmentFormat = toVk(desc.depthFormat),
      .stencilAttachmentFormat = stencil ? toVk(desc.depthFormat) : VK_FORMAT_UNDEFINED,
  };
  const VkGraphicsPipelineCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
      .pNext = &rendering,
      .stageCount = uint32_t(stages.infos().size()),
      .pStages = stages.infos().data(),
      .pVertexInputState = &vertexInput,
      .pInputAssemblyState = &assembly,
      .pViewportState = &viewport,
      .pRasterizationState = &raster,
      .pMultisampleState = &samples,
      .pDepthStencilState = &depthStencil,
      .pColorBlendState = &blend,
      .pDynamicState = &dynamic,
      .layout = pipeline.layout->layout,
  };
  check(context.vk.vkCreateGraphicsPipelines(context.device, context.pipelineCache, 1, &info,
                                             nullptr, &pipeline.handle),
        "vkCreateGraphicsPipelines", desc.label);
  context.name(pipeline.handle, VK_OBJECT_TYPE_PIPELINE, desc.label);
  return pipeline;
}

Pipeline createPipeline(const Context& context, PipelineLayouts& layouts,
                        const rhi::ComputePipelineDesc& desc) {
  const rhi::ShaderCode* codes[] = {desc.compute};
  const Stages stages(context, desc.label, codes, desc.constants);
  Pipeline pipeline = {.label = desc.label,
                       .layout = &layouts.get(codes, true),
                       .bindPoint = VK_PIPELINE_BIND_POINT_COMPUTE};
  const VkComputePipelineCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
      .stage = stages.infos()[0],
      .layout = pipeline.layout->layout,
  };
  check(context.vk.vkCreateComputePipelines(context.device, context.pipelineCache, 1, &info,
                                            nullptr, &pipeline.handle),
        "vkCreateComputePipelines", desc.label);
  context.name(pipeline.handle, VK_OBJECT_TYPE_PIPELINE, desc.label);
  return pipeline;
}

}  // namespace vulkan
