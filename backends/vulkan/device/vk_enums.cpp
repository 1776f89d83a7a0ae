#include "backends/vulkan/device/vk_enums.h"

namespace vulkan {

VkCompareOp toVk(rhi::CompareOp op) { return VkCompareOp(op); }
static_assert(VK_COMPARE_OP_LESS == int(rhi::CompareOp::Less));
static_assert(VK_COMPARE_OP_GREATER_OR_EQUAL == int(rhi::CompareOp::GreaterOrEqual));
static_assert(VK_COMPARE_OP_ALWAYS == int(rhi::CompareOp::Always));

VkStencilOp toVk(rhi::StencilOp op) { return VkStencilOp(op); }
static_assert(VK_STENCIL_OP_REPLACE == int(rhi::StencilOp::Replace));
static_assert(VK_STENCIL_OP_INVERT == int(rhi::StencilOp::Invert));
static_assert(VK_STENCIL_OP_DECREMENT_AND_WRAP == int(rhi::StencilOp::DecrementWrap));

VkBlendOp toVk(rhi::BlendOp op) { return VkBlendOp(op); }
static_assert(VK_BLEND_OP_REVERSE_SUBTRACT == int(rhi::BlendOp::ReverseSubtract));
static_assert(VK_BLEND_OP_MAX == int(rhi::BlendOp::Max));

VkBlendFactor toVk(rhi::BlendFactor factor) {
  static constexpr VkBlendFactor kTable[] = {
      VK_BLEND_FACTOR_ZERO,           VK_BLEND_FACTOR_ONE,
      VK_BLEND_FACTOR_SRC_COLOR,      VK_BLEND_FACTOR_ONE_MINUS_SRC_COLOR,
      VK_BLEND_FACTOR_DST_COLOR,      VK_BLEND_FACTOR_ONE_MINUS_DST_COLOR,
      VK_BLEND_FACTOR_SRC_ALPHA,      VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA,
      VK_BLEND_FACTOR_DST_ALPHA,      VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA,
      VK_BLEND_FACTOR_CONSTANT_COLOR, VK_BLEND_FACTOR_ONE_MINUS_CONSTANT_COLOR,
      VK_BLEND_FACTOR_SRC1_COLOR,     VK_BLEND_FACTOR_ONE_MINUS_SRC1_COLOR,
      VK_BLEND_FACTOR_SRC1_ALPHA,     VK_BLEND_FACTOR_ONE_MINUS_SRC1_ALPHA,
  };
  static_assert(std::size(kTable) == size_t(rhi::BlendFactor::OneMinusSrc1Alpha) + 1);
  return kTable[size_t(factor)];
}

VkLogicOp toVk(rhi::LogicOp op) {
  static constexpr VkLogicOp kTable[] = {VK_LOGIC_OP_COPY,  VK_LOGIC_OP_AND, VK_LOGIC_OP_OR,
                                         VK_LOGIC_OP_XOR,   VK_LOGIC_OP_SET, VK_LOGIC_OP_CLEAR,
                                         VK_LOGIC_OP_INVERT};
  return kTable[size_t(op)];
}

VkCullModeFlags toVk(rhi::CullMode mode) { return VkCullModeFlags(mode); }
static_assert(VK_CULL_MODE_NONE == int(rhi::CullMode::None));
static_assert(VK_CULL_MODE_FRONT_BIT == int(rhi::CullMode::Front));
static_assert(VK_CULL_MODE_BACK_BIT == int(rhi::CullMode::Back));

VkPrimitiveTopology toVk(rhi::Topology topology) {
  static constexpr VkPrimitiveTopology kTable[] = {
      VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP,
      VK_PRIMITIVE_TOPOLOGY_LINE_LIST, VK_PRIMITIVE_TOPOLOGY_POINT_LIST,
      VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST_WITH_ADJACENCY};
  return kTable[size_t(topology)];
}

VkAttachmentLoadOp toVk(rhi::LoadOp op) { return VkAttachmentLoadOp(op); }
static_assert(VK_ATTACHMENT_LOAD_OP_LOAD == int(rhi::LoadOp::Load));
static_assert(VK_ATTACHMENT_LOAD_OP_DONT_CARE == int(rhi::LoadOp::DontCare));

VkAttachmentStoreOp toVk(rhi::StoreOp op) { return VkAttachmentStoreOp(op); }
static_assert(VK_ATTACHMENT_STORE_OP_DONT_CARE == int(rhi::StoreOp::DontCare));

VkFilter toVk(rhi::Filter filter) { return VkFilter(filter); }
static_assert(VK_FILTER_LINEAR == int(rhi::Filter::Linear));

VkSamplerAddressMode toVk(rhi::AddressMode mode) { return VkSamplerAddressMode(mode); }
static_assert(VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER == int(rhi::AddressMode::ClampToBorder));
static_assert(VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT == int(rhi::AddressMode::MirroredRepeat));

VkShaderStageFlagBits toVk(rhi::ShaderStage stage) {
  static constexpr VkShaderStageFlagBits kTable[] = {
      VK_SHADER_STAGE_VERTEX_BIT, VK_SHADER_STAGE_GEOMETRY_BIT, VK_SHADER_STAGE_FRAGMENT_BIT,
      VK_SHADER_STAGE_COMPUTE_BIT};
  return kTable[size_t(stage)];
}

}  // namespace vulkan
