#include <cstring>

#include "backends/vulkan/device/vk_formats.h"
#include "tests/baseline/by_hand_vulkan_objects.h"

namespace sb::baseline {
namespace {

using vulkan::check;

class VulkanFrame final : public ByHand {
 public:
  explicit VulkanFrame(const Capture& capture)
      : m_capture(capture), m_objects(capture), m_context(*m_objects.context), m_vk(m_objects.vk) {
    createCommands();
    begin();
    for (const auto& [id, image] : m_objects.images) toGeneral(image, capture.textures.at(id));
    submitCommands();
    wait();
  }

  ~VulkanFrame() override {
    m_vk.vkDeviceWaitIdle(m_context.device);
    m_vk.vkDestroyFence(m_context.device, m_fence, nullptr);
    m_vk.vkDestroyCommandPool(m_context.device, m_commandPool, nullptr);
  }

  void submit() override {
    begin();
    for (size_t i = 0; i < m_capture.passes.size(); ++i)
      recordPass(m_capture.passes[i], m_objects.sets[i]);
    submitCommands();
  }

  void wait() override {
    check(m_vk.vkWaitForFences(m_context.device, 1, &m_fence, VK_TRUE, UINT64_MAX),
          "vkWaitForFences");
    check(m_vk.vkResetFences(m_context.device, 1, &m_fence), "vkResetFences");
  }

  std::vector<std::byte> picture() override {
    const rhi::TextureDesc& desc = m_capture.textures.at(m_capture.picture);
    const uint64_t size = uint64_t(desc.width) * desc.height * 8;
    std::byte* mapped = nullptr;
    const VkBuffer buffer =
        m_objects.createBuffer({.label = "picture", .size = size}, nullptr, &mapped);
    begin();
    barrier();
    const VkBufferImageCopy copy = {.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                                    .imageExtent = {desc.width, desc.height, 1}};
    m_vk.vkCmdCopyImageToBuffer(m_commands, m_objects.images.at(m_capture.picture).handle,
                                VK_IMAGE_LAYOUT_GENERAL, buffer, 1, &copy);
    barrier();
    submitCommands();
    wait();
    std::vector<std::byte> bytes(mapped, mapped + size);
    m_vk.vkDestroyBuffer(m_context.device, buffer, nullptr);
    return bytes;
  }

 private:
  using Image = Objects::Image;
  using Set = Objects::Set;

  void createCommands() {
    const VkCommandPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                          .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT,
                                          .queueFamilyIndex = m_context.physical().queueFamily};
    check(m_vk.vkCreateCommandPool(m_context.device, &pool, nullptr, &m_commandPool),
          "vkCreateCommandPool");
    const VkCommandBufferAllocateInfo buffer = {
        .sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
        .commandPool = m_commandPool,
        .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
        .commandBufferCount = 1};
    check(m_vk.vkAllocateCommandBuffers(m_context.device, &buffer, &m_commands),
          "vkAllocateCommandBuffers");
    const VkFenceCreateInfo fence = {.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    check(m_vk.vkCreateFence(m_context.device, &fence, nullptr, &m_fence), "vkCreateFence");
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
    check(m_vk.vkQueueSubmit(m_context.queue, 1, &info, m_fence), "vkQueueSubmit");
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
            .imageView = m_objects.images.at(view.texture).view,
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
      const vulkan::Pipeline& pipeline = m_objects.pipelines.at(draw.pipeline);
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
      buffers[i] = m_objects.buffers.at(draw.vertexBuffers[i].buffer);
    m_vk.vkCmdBindVertexBuffers(m_commands, 0, uint32_t(draw.vertexBuffers.size()), buffers,
                                offsets);
    m_vk.vkCmdBindIndexBuffer(m_commands, m_objects.buffers.at(draw.indexBuffer), 0,
                              VK_INDEX_TYPE_UINT32);
  }

  const Capture& m_capture;
  Objects m_objects;
  const vulkan::Context& m_context;
  const VolkDeviceTable& m_vk;
  VkCommandPool m_commandPool = VK_NULL_HANDLE;
  VkCommandBuffer m_commands = VK_NULL_HANDLE;
  VkFence m_fence = VK_NULL_HANDLE;
};

}  // namespace

std::unique_ptr<ByHand> makeVulkan(const Capture& capture) {
  return std::make_unique<VulkanFrame>(capture);
}

}  // namespace sb::baseline
