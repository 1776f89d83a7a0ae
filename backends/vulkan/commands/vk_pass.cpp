// Passes: barriers from what is declared, then dynamic rendering.
#include <algorithm>
#include <cassert>

#include "backends/vulkan/commands/vk_command_list.h"
#include "backends/vulkan/device/vk_enums.h"
#include "backends/vulkan/device/vk_formats.h"

namespace vulkan {
namespace {

struct StageAccess {
  VkPipelineStageFlags2 stages;
  VkAccessFlags2 access;
};

StageAccess stageAccessOf(rhi::Access access, VkPipelineStageFlags2 shaders) {
  switch (access) {
    case rhi::Access::Uniform:
      return {shaders, VK_ACCESS_2_UNIFORM_READ_BIT};
    case rhi::Access::Vertex:
      return {VK_PIPELINE_STAGE_2_VERTEX_ATTRIBUTE_INPUT_BIT,
              VK_ACCESS_2_VERTEX_ATTRIBUTE_READ_BIT};
    case rhi::Access::Index:
      return {VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT, VK_ACCESS_2_INDEX_READ_BIT};
    case rhi::Access::Indirect:
      return {VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT};
    case rhi::Access::Sampled:
      return {shaders, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT};
    case rhi::Access::StorageRead:
      return {shaders, VK_ACCESS_2_SHADER_STORAGE_READ_BIT};
    case rhi::Access::StorageWrite:
      return {shaders, VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT};
  }
  assert(false);
  return {};
}

constexpr VkPipelineStageFlags2 kDepthStages =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
constexpr VkAccessFlags2 kColorAccess =
    VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;

VkClearColorValue clearOf(const std::array<float, 4>& value, rhi::Format format) {
  VkClearColorValue clear = {};
  for (int i = 0; i < 4; ++i) switch (rhi::formatInfo(format).kind) {
      case rhi::FormatKind::Uint:
        clear.uint32[i] = rhi::integerClear<uint32_t>(value[i]);
        break;
      case rhi::FormatKind::Sint:
        clear.int32[i] = rhi::integerClear<int32_t>(value[i]);
        break;
      default:
        clear.float32[i] = value[i];
    }
  return clear;
}

bool isInteger(rhi::Format format) {
  const rhi::FormatKind kind = rhi::formatInfo(format).kind;
  return kind == rhi::FormatKind::Uint || kind == rhi::FormatKind::Sint;
}

bool hasStencil(const Texture& texture) { return rhi::formatInfo(texture.desc.format).stencil; }

// The rest layout of depth lets stencil be written.
VkImageLayout attachmentLayout(const Texture& texture, const rhi::DepthAttachment& depth) {
  return depth.readOnly ? texture.restLayout : VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
}

// A store counts as a write, which a read-only layout does not allow.
VkAttachmentStoreOp storeOf(rhi::StoreOp store, bool readOnly) {
  return readOnly ? VK_ATTACHMENT_STORE_OP_NONE : toVk(store);
}

}  // namespace

void CommandList::wantAttachments(const rhi::PassDesc& desc) {
  Barriers& barriers = m_device.barriers();
  auto wantColor = [&](const rhi::TextureView& view, bool discard) {
    Texture& texture = m_device.get(view.texture);
    barriers.want(texture, texture.resolve(view), VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                  kColorAccess, true, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, discard);
  };
  for (const rhi::ColorAttachment& color : desc.colors) {
    wantColor(color.view, color.load != rhi::LoadOp::Load);
    if (color.resolve) wantColor(*color.resolve, true);
  }
  if (!desc.depth) return;
  Texture& texture = m_device.get(desc.depth->view.texture);
  const bool stencil = hasStencil(texture);
  const bool write = !desc.depth->readOnly || (stencil && !desc.depth->stencilReadOnly);
  const bool loads = desc.depth->load == rhi::LoadOp::Load ||
                     (stencil && desc.depth->stencilLoad == rhi::LoadOp::Load);
  barriers.want(texture, texture.resolve(desc.depth->view), kDepthStages,
                VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
                    (write ? VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT : VkAccessFlags2(0)),
                write, attachmentLayout(texture, *desc.depth), !loads);
}

void CommandList::wantUse(const rhi::ResourceUse& use, bool compute) {
  const VkPipelineStageFlags2 shaders = compute
                                            ? VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT
                                            : VK_PIPELINE_STAGE_2_PRE_RASTERIZATION_SHADERS_BIT |
                                                  VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
  const StageAccess want = stageAccessOf(use.access, shaders);
  const bool write = use.access == rhi::Access::StorageWrite;
  if (use.buffer) {
    m_device.barriers().want(m_device.get(use.buffer), want.stages, want.access, write);
    return;
  }
  Texture& texture = m_device.get(use.view.texture);
  m_device.barriers().want(texture, texture.resolve(use.view), want.stages, want.access, write,
                           texture.restLayout, false);
}

void CommandList::synchronise(const rhi::PassDesc& desc) {
  Barriers& barriers = m_device.barriers();
  barriers.endTransfers(m_commands);
  wantAttachments(desc);
  for (const rhi::ResourceUse& use : desc.reads) wantUse(use, desc.compute);
  for (const rhi::ResourceUse& use : desc.writes) wantUse(use, desc.compute);
  barriers.flush(m_commands);
}

VkRenderingAttachmentInfo CommandList::colorAttachment(const rhi::ColorAttachment& color) {
  Texture& texture = m_device.get(color.view.texture);
  VkRenderingAttachmentInfo info = {
      .sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
      .imageView = viewOf(m_context, texture, texture.resolve(color.view), texture.aspects),
      .imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
      .loadOp = toVk(color.load),
      .storeOp = toVk(color.store),
      .clearValue = {.color = clearOf(color.clear, texture.desc.format)},
  };
  if (color.resolve) {
    Texture& target = m_device.get(color.resolve->texture);
    info.resolveMode = isInteger(texture.desc.format) ? VK_RESOLVE_MODE_SAMPLE_ZERO_BIT
                                                      : VK_RESOLVE_MODE_AVERAGE_BIT;
    info.resolveImageView =
        viewOf(m_context, target, target.resolve(*color.resolve), target.aspects);
    info.resolveImageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  }
  return info;
}

VkRenderingAttachmentInfo CommandList::depthAttachment(const rhi::DepthAttachment& depth) {
  Texture& texture = m_device.get(depth.view.texture);
  return {
      .sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
      .imageView = viewOf(m_context, texture, texture.resolve(depth.view), texture.aspects),
      .imageLayout = attachmentLayout(texture, depth),
      .loadOp = toVk(depth.load),
      .storeOp = storeOf(depth.store, depth.readOnly),
      .clearValue = {.depthStencil = {depth.clearDepth, depth.clearStencil}},
  };
}

void CommandList::beginRendering(const rhi::PassDesc& desc) {
  std::array<VkRenderingAttachmentInfo, rhi::kMaxColorAttachments> colors;
  assert(desc.colors.size() <= colors.size());
  assert(!desc.depth || !desc.depth->readOnly || desc.depth->load != rhi::LoadOp::Clear);
  assert(!desc.depth || !desc.depth->stencilReadOnly ||
         desc.depth->stencilLoad != rhi::LoadOp::Clear);
  m_extent = desc.extent;
  uint32_t layers = 1;
  auto measure = [&](const rhi::TextureView& view) {
    const Texture& texture = m_device.get(view.texture);
    m_extent = {std::max(1u, texture.desc.width >> view.baseMip),
                std::max(1u, texture.desc.height >> view.baseMip)};
    layers = texture.resolve(view).layerCount;
  };
  for (size_t i = 0; i < desc.colors.size(); ++i) {
    colors[i] = colorAttachment(desc.colors[i]);
    measure(desc.colors[i].view);
  }
  VkRenderingAttachmentInfo depth, stencil;
  if (desc.depth) {
    depth = stencil = depthAttachment(*desc.depth);
    stencil.loadOp = toVk(desc.depth->stencilLoad);
    stencil.storeOp = storeOf(desc.depth->stencilStore, desc.depth->stencilReadOnly);
    measure(desc.depth->view);
  }
  assert(m_extent.width > 0 && "a pass without attachments needs an extent");
  const VkRenderingInfo info = {
      .sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
      .renderArea = {{0, 0}, {m_extent.width, m_extent.height}},
      .layerCount = layers,
      .colorAttachmentCount = uint32_t(desc.colors.size()),
      .pColorAttachments = colors.data(),
      .pDepthAttachment = desc.depth ? &depth : nullptr,
      .pStencilAttachment =
          desc.depth && hasStencil(m_device.get(desc.depth->view.texture)) ? &stencil : nullptr,
  };
  m_vk.vkCmdBeginRendering(m_commands, &info);
}

void CommandList::doBeginPass(const rhi::PassDesc& desc) {
  if (m_context.cmdBeginLabel) {
    const VkDebugUtilsLabelEXT label = {.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT,
                                        .pLabelName = desc.label.c_str()};
    m_context.cmdBeginLabel(m_commands, &label);
  }
  synchronise(desc);
  m_rendering = !desc.compute;
  if (m_rendering) beginRendering(desc);
}

void CommandList::doEndPass() {
  if (m_rendering) m_vk.vkCmdEndRendering(m_commands);
  m_rendering = false;
  if (m_context.cmdEndLabel) m_context.cmdEndLabel(m_commands);
}

}  // namespace vulkan
