#include <algorithm>
#include <cstring>

#include "backends/vulkan/vk_enums.h"
#include "backends/vulkan/vk_formats.h"
#include "backends/vulkan/vk_memory.h"
#include "backends/vulkan/vk_pipeline.h"
#include "tests/baseline/by_hand.h"

namespace sb::baseline {
namespace {

using vulkan::check;

struct Image {
  VkImage handle = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
};

std::unique_ptr<vulkan::Context> openFirstDevice() {
  auto instance = std::make_unique<vulkan::Instance>(false);
  const auto devices = vulkan::describeDevices(*instance);
  return std::make_unique<vulkan::Context>(std::move(instance), devices.at(0));
}

class VulkanFrame final : public ByHand {
 public:
  explicit VulkanFrame(const Capture& capture)
      : m_capture(capture),
        m_context(openFirstDevice()),
        m_vk(m_context->vk),
        m_memory(std::make_unique<vulkan::Memory>(*m_context)),
        m_layouts(std::make_unique<vulkan::PipelineLayouts>(*m_context)) {
    createCommands();
    for (const auto& [id, b] : capture.buffers) m_buffers[id] = createBuffer(b.desc, &b.bytes);
    for (const auto& [id, t] : capture.textures) m_images[id] = createImage(t);
    for (const auto& [id, s] : capture.samplers) m_samplers[id] = createSampler();
    for (const auto& [id, p] : capture.pipelines)
      m_pipelines[id] = vulkan::createPipeline(*m_context, *m_layouts, p);
    createSets();
    begin();
    for (const auto& [id, image] : m_images) toGeneral(image, capture.textures.at(id));
    submitCommands();
    wait();
  }

  ~VulkanFrame() override {
    const VkDevice d = m_context->device;
    m_vk.vkDeviceWaitIdle(d);
    for (const auto& [id, p] : m_pipelines) m_vk.vkDestroyPipeline(d, p.handle, nullptr);
    for (const auto& [id, s] : m_samplers) m_vk.vkDestroySampler(d, s, nullptr);
    for (const auto& [id, i] : m_images) {
      m_vk.vkDestroyImageView(d, i.view, nullptr);
      m_vk.vkDestroyImage(d, i.handle, nullptr);
    }
    for (const auto& [id, b] : m_buffers) m_vk.vkDestroyBuffer(d, b, nullptr);
    m_vk.vkDestroyDescriptorPool(d, m_descriptors, nullptr);
    m_vk.vkDestroyFence(d, m_fence, nullptr);
    m_vk.vkDestroyCommandPool(d, m_commandPool, nullptr);
  }

  void submit() override {
    begin();
    for (size_t i = 0; i < m_capture.passes.size(); ++i) recordPass(m_capture.passes[i], m_sets[i]);
    submitCommands();
  }

  void wait() override {
    check(m_vk.vkWaitForFences(m_context->device, 1, &m_fence, VK_TRUE, UINT64_MAX),
          "vkWaitForFences");
    check(m_vk.vkResetFences(m_context->device, 1, &m_fence), "vkResetFences");
  }

  std::vector<std::byte> picture() override {
    const rhi::TextureDesc& desc = m_capture.textures.at(m_capture.picture);
    const uint64_t size = uint64_t(desc.width) * desc.height * 8;
    std::byte* mapped = nullptr;
    const VkBuffer buffer = createBuffer({.label = "picture", .size = size}, nullptr, &mapped);
    begin();
    barrier();
    const VkBufferImageCopy copy = {.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                                    .imageExtent = {desc.width, desc.height, 1}};
    m_vk.vkCmdCopyImageToBuffer(m_commands, m_images.at(m_capture.picture).handle,
                                VK_IMAGE_LAYOUT_GENERAL, buffer, 1, &copy);
    barrier();
    submitCommands();
    wait();
    std::vector<std::byte> bytes(mapped, mapped + size);
    m_vk.vkDestroyBuffer(m_context->device, buffer, nullptr);
    return bytes;
  }

 private:
  /// What a draw binds.
  struct Set {
    VkDescriptorSet set = VK_NULL_HANDLE;
    std::vector<uint32_t> offsets;
    bool operator==(const Set&) const = default;
  };

  void createCommands() {
    const VkCommandPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                          .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT,
                                          .queueFamilyIndex = m_context->physical().queueFamily};
    check(m_vk.vkCreateCommandPool(m_context->device, &pool, nullptr, &m_commandPool),
          "vkCreateCommandPool");
    const VkCommandBufferAllocateInfo buffer = {
        .sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
        .commandPool = m_commandPool,
        .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
        .commandBufferCount = 1};
    check(m_vk.vkAllocateCommandBuffers(m_context->device, &buffer, &m_commands),
          "vkAllocateCommandBuffers");
    const VkFenceCreateInfo fence = {.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    check(m_vk.vkCreateFence(m_context->device, &fence, nullptr, &m_fence), "vkCreateFence");
  }

  VkBuffer createBuffer(const rhi::BufferDesc& desc, const std::vector<std::byte>* bytes,
                        std::byte** mapped = nullptr) {
    const VkBufferCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
        .size = desc.size,
        .usage = VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT |
                 VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                 VK_BUFFER_USAGE_TRANSFER_DST_BIT};
    VkBuffer buffer = VK_NULL_HANDLE;
    check(m_vk.vkCreateBuffer(m_context->device, &info, nullptr, &buffer), "vkCreateBuffer");
    VkMemoryRequirements needs;
    m_vk.vkGetBufferMemoryRequirements(m_context->device, buffer, &needs);
    const auto kind = bytes ? vulkan::MemoryKind::Upload : vulkan::MemoryKind::Readback;
    const vulkan::Allocation at = m_memory->allocate(needs, kind, false, desc.label);
    check(m_vk.vkBindBufferMemory(m_context->device, buffer, at.memory, at.offset),
          "vkBindBufferMemory");
    if (bytes) std::memcpy(at.mapped, bytes->data(), bytes->size());
    if (mapped) *mapped = at.mapped;
    return buffer;
  }

  Image createImage(const rhi::TextureDesc& desc) {
    const bool depth = rhi::formatInfo(desc.format).depth;
    VkImageUsageFlags usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    if (has(desc.use, rhi::TextureUse::ColorTarget)) usage |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    if (depth) usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    const VkImageCreateInfo info = {.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                    .imageType = VK_IMAGE_TYPE_2D,
                                    .format = vulkan::toVk(desc.format),
                                    .extent = {desc.width, desc.height, 1},
                                    .mipLevels = 1,
                                    .arrayLayers = desc.layers,
                                    .samples = VK_SAMPLE_COUNT_1_BIT,
                                    .tiling = VK_IMAGE_TILING_OPTIMAL,
                                    .usage = usage};
    Image image;
    check(m_vk.vkCreateImage(m_context->device, &info, nullptr, &image.handle), "vkCreateImage");
    VkMemoryRequirements needs;
    m_vk.vkGetImageMemoryRequirements(m_context->device, image.handle, &needs);
    const vulkan::Allocation at =
        m_memory->allocate(needs, vulkan::MemoryKind::Device, true, desc.label);
    check(m_vk.vkBindImageMemory(m_context->device, image.handle, at.memory, at.offset),
          "vkBindImageMemory");
    const VkImageViewCreateInfo view = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
        .image = image.handle,
        .viewType = desc.kind == rhi::TextureKind::Tex2DArray ? VK_IMAGE_VIEW_TYPE_2D_ARRAY
                                                              : VK_IMAGE_VIEW_TYPE_2D,
        .format = info.format,
        .subresourceRange = {vulkan::aspectsOf(desc.format), 0, 1, 0, desc.layers}};
    check(m_vk.vkCreateImageView(m_context->device, &view, nullptr, &image.view),
          "vkCreateImageView");
    return image;
  }

  /// Lookups fetch texels: no filter matters.
  VkSampler createSampler() {
    const VkSamplerCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    VkSampler sampler = VK_NULL_HANDLE;
    check(m_vk.vkCreateSampler(m_context->device, &info, nullptr, &sampler), "vkCreateSampler");
    return sampler;
  }

  void createSets() {
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC, 1024},
                                          {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1024},
                                          {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1024}};
    const VkDescriptorPoolCreateInfo info = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                             .maxSets = 64,
                                             .poolSizeCount = 3,
                                             .pPoolSizes = sizes};
    check(m_vk.vkCreateDescriptorPool(m_context->device, &info, nullptr, &m_descriptors),
          "vkCreateDescriptorPool");
    // A set for each pipeline of a pass; its draws differ in offsets alone.
    for (const CapturedPass& pass : m_capture.passes) {
      IdMap<rhi::PipelineId, VkDescriptorSet> ofPipeline;
      auto& sets = m_sets.emplace_back();
      for (const CapturedDraw& draw : pass.draws) {
        auto [it, isNew] = ofPipeline.try_emplace(draw.pipeline);
        if (isNew) it->second = createSet(draw);
        Set& set = sets.emplace_back(Set{it->second, {}});
        for (const auto& [slot, type] : m_pipelines.at(draw.pipeline).layout->slots)
          if (slot < rhi::kStorageSlotBase)
            set.offsets.push_back(uint32_t(bindingAt(draw, slot).offset));
      }
    }
  }

  static const rhi::Binding& bindingAt(const CapturedDraw& draw, uint32_t slot) {
    return *std::ranges::find(draw.bindings, slot, &rhi::Binding::slot);
  }

  VkDescriptorSet createSet(const CapturedDraw& draw) {
    const vulkan::PipelineLayout& layout = *m_pipelines.at(draw.pipeline).layout;
    const VkDescriptorSetAllocateInfo info = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
        .descriptorPool = m_descriptors,
        .descriptorSetCount = 1,
        .pSetLayouts = &layout.set};
    VkDescriptorSet set = VK_NULL_HANDLE;
    check(m_vk.vkAllocateDescriptorSets(m_context->device, &info, &set),
          "vkAllocateDescriptorSets");
    for (const auto& [slot, type] : layout.slots) {
      const rhi::Binding& b = bindingAt(draw, slot);
      const bool texture = type == VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
      VkDescriptorImageInfo image = {};
      VkDescriptorBufferInfo buffer = {};
      if (texture)
        image = {m_samplers.at(b.sampler), m_images.at(b.view.texture).view,
                 VK_IMAGE_LAYOUT_GENERAL};
      else
        buffer = {m_buffers.at(b.buffer), 0, b.size == rhi::kWholeSize ? VK_WHOLE_SIZE : b.size};
      const VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                          .dstSet = set,
                                          .dstBinding = slot,
                                          .descriptorCount = 1,
                                          .descriptorType = type,
                                          .pImageInfo = &image,
                                          .pBufferInfo = &buffer};
      m_vk.vkUpdateDescriptorSets(m_context->device, 1, &write, 0, nullptr);
    }
    return set;
  }

  void begin() {
    const VkCommandBufferBeginInfo info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                           .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
    check(m_vk.vkBeginCommandBuffer(m_commands, &info), "vkBeginCommandBuffer");
  }

  void submitCommands() {
    check(m_vk.vkEndCommandBuffer(m_commands), "vkEndCommandBuffer");
    const VkSubmitInfo info = {.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO,
                               .commandBufferCount = 1,
                               .pCommandBuffers = &m_commands};
    check(m_vk.vkQueueSubmit(m_context->queue, 1, &info, m_fence), "vkQueueSubmit");
  }

  void barrier() {
    const VkMemoryBarrier all = {
        .sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
        .srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT,
        .dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT};
    m_vk.vkCmdPipelineBarrier(m_commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                              VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 1, &all, 0, nullptr, 0,
                              nullptr);
  }

  void toGeneral(const Image& image, const rhi::TextureDesc& desc) {
    const VkImageMemoryBarrier change = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
        .newLayout = VK_IMAGE_LAYOUT_GENERAL,
        .image = image.handle,
        .subresourceRange = {vulkan::aspectsOf(desc.format), 0, 1, 0, desc.layers}};
    m_vk.vkCmdPipelineBarrier(m_commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                              VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0, nullptr, 0, nullptr, 1,
                              &change);
  }

  VkRenderingAttachmentInfo attachment(const rhi::TextureView& view, rhi::LoadOp load,
                                       VkClearValue clear) const {
    return {.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
            .imageView = m_images.at(view.texture).view,
            .imageLayout = VK_IMAGE_LAYOUT_GENERAL,
            .loadOp = load == rhi::LoadOp::Clear ? VK_ATTACHMENT_LOAD_OP_CLEAR
                                                 : VK_ATTACHMENT_LOAD_OP_LOAD,
            .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
            .clearValue = clear};
  }

  void recordPass(const CapturedPass& pass, const std::vector<Set>& sets) {
    barrier();
    VkRenderingAttachmentInfo color = {}, depth = {};
    const rhi::TextureView& any = pass.colors.empty() ? pass.depth->view : pass.colors[0].view;
    const rhi::TextureDesc& target = m_capture.textures.at(any.texture);
    VkRenderingInfo info = {.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                            .renderArea = {{0, 0}, {target.width, target.height}},
                            .layerCount = 1};
    if (!pass.colors.empty()) {
      VkClearValue clear;
      std::memcpy(clear.color.float32, pass.colors[0].clear.data(), 16);
      color = attachment(pass.colors[0].view, pass.colors[0].load, clear);
      info.colorAttachmentCount = 1;
      info.pColorAttachments = &color;
    }
    if (pass.depth) {
      depth = attachment(pass.depth->view, pass.depth->load,
                         {.depthStencil = {pass.depth->clearDepth, 0}});
      info.pDepthAttachment = &depth;
    }
    m_vk.vkCmdBeginRendering(m_commands, &info);
    const VkViewport viewport = {0, 0, float(target.width), float(target.height), 0, 1};
    m_vk.vkCmdSetViewport(m_commands, 0, 1, &viewport);
    m_vk.vkCmdSetScissor(m_commands, 0, 1, &info.renderArea);
    m_vk.vkCmdSetStencilReference(m_commands, VK_STENCIL_FACE_FRONT_AND_BACK, 0);
    const float none[4] = {};
    m_vk.vkCmdSetBlendConstants(m_commands, none);
    recordDraws(pass, sets);
    m_vk.vkCmdEndRendering(m_commands);
  }

  void recordDraws(const CapturedPass& pass, const std::vector<Set>& sets) {
    for (size_t i = 0; i < pass.draws.size(); ++i) {
      const CapturedDraw& draw = pass.draws[i];
      if (i == 0) bindGeometry(draw);
      const bool samePipeline = i > 0 && draw.pipeline == pass.draws[i - 1].pipeline;
      const vulkan::Pipeline& pipeline = m_pipelines.at(draw.pipeline);
      if (!samePipeline)
        m_vk.vkCmdBindPipeline(m_commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.handle);
      if (!samePipeline || !(sets[i] == sets[i - 1]))
        m_vk.vkCmdBindDescriptorSets(m_commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                                     pipeline.layout->layout, 0, 1, &sets[i].set,
                                     uint32_t(sets[i].offsets.size()), sets[i].offsets.data());
      m_vk.vkCmdDrawIndexed(m_commands, draw.args.indexCount, 1, draw.args.firstIndex,
                            draw.args.vertexOffset, draw.args.firstInstance);
    }
  }

  /// The draws of a pass share all buffers.
  void bindGeometry(const CapturedDraw& draw) {
    VkBuffer buffers[3];
    const VkDeviceSize offsets[3] = {};
    for (size_t i = 0; i < draw.vertexBuffers.size(); ++i)
      buffers[i] = m_buffers.at(draw.vertexBuffers[i].buffer);
    m_vk.vkCmdBindVertexBuffers(m_commands, 0, uint32_t(draw.vertexBuffers.size()), buffers,
                                offsets);
    m_vk.vkCmdBindIndexBuffer(m_commands, m_buffers.at(draw.indexBuffer), 0, VK_INDEX_TYPE_UINT32);
  }

  const Capture& m_capture;
  std::unique_ptr<vulkan::Context> m_context;
  const VolkDeviceTable& m_vk;
  std::unique_ptr<vulkan::Memory> m_memory;
  std::unique_ptr<vulkan::PipelineLayouts> m_layouts;
  VkCommandPool m_commandPool = VK_NULL_HANDLE;
  VkCommandBuffer m_commands = VK_NULL_HANDLE;
  VkFence m_fence = VK_NULL_HANDLE;
  VkDescriptorPool m_descriptors = VK_NULL_HANDLE;
  IdMap<rhi::BufferId, VkBuffer> m_buffers;
  IdMap<rhi::TextureId, Image> m_images;
  IdMap<rhi::SamplerId, VkSampler> m_samplers;
  IdMap<rhi::PipelineId, vulkan::Pipeline> m_pipelines;
  std::vector<std::vector<Set>> m_sets;  ///< by pass and draw
};

}  // namespace

std::unique_ptr<ByHand> makeVulkan(const Capture& capture) {
  return std::make_unique<VulkanFrame>(capture);
}

}  // namespace sb::baseline
