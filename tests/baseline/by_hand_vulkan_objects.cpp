#include "tests/baseline/by_hand_vulkan_objects.h"

#include <algorithm>
#include <cstring>

#include "backends/vulkan/device/vk_enums.h"
#include "backends/vulkan/device/vk_formats.h"

namespace sb::baseline {
namespace {

using vulkan::check;

std::unique_ptr<vulkan::Context> openFirstDevice() {
  auto instance = std::make_unique<vulkan::Instance>(false);
  const auto devices = vulkan::describeDevices(*instance);
  return std::make_unique<vulkan::Context>(std::move(instance), devices.at(0));
}

const rhi::Binding& bindingAt(const CapturedDraw& draw, uint32_t slot) {
  return *std::ranges::find(draw.bindings, slot, &rhi::Binding::slot);
}

}  // namespace

Objects::Objects(const Capture& from)
    : capture(from),
      context(openFirstDevice()),
      vk(context->vk),
      m_memory(std::make_unique<vulkan::Memory>(*context)),
      m_layouts(std::make_unique<vulkan::PipelineLayouts>(*context)) {
  for (const auto& [id, b] : capture.buffers) buffers[id] = createBuffer(b.desc, &b.bytes);
  for (const auto& [id, t] : capture.textures) images[id] = createImage(t);
  for (const auto& [id, s] : capture.samplers) m_samplers[id] = createSampler();
  for (const auto& [id, p] : capture.pipelines)
    pipelines[id] = vulkan::createPipeline(*context, *m_layouts, p);
  createSets();
}

Objects::~Objects() {
  const VkDevice d = context->device;
  vk.vkDeviceWaitIdle(d);
  for (const auto& [id, p] : pipelines) vk.vkDestroyPipeline(d, p.handle, nullptr);
  for (const auto& [id, s] : m_samplers) vk.vkDestroySampler(d, s, nullptr);
  for (const auto& [id, i] : images) {
    vk.vkDestroyImageView(d, i.view, nullptr);
    vk.vkDestroyImage(d, i.handle, nullptr);
  }
  for (const auto& [id, b] : buffers) vk.vkDestroyBuffer(d, b, nullptr);
  vk.vkDestroyDescriptorPool(d, m_descriptors, nullptr);
}

VkBuffer Objects::createBuffer(const rhi::BufferDesc& desc, const std::vector<std::byte>* bytes,
                               std::byte** mapped) {
  const VkBufferCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
      .size = desc.size,
      .usage = VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT |
               VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
               VK_BUFFER_USAGE_TRANSFER_DST_BIT};
  VkBuffer buffer = VK_NULL_HANDLE;
  check(vk.vkCreateBuffer(context->device, &info, nullptr, &buffer), "vkCreateBuffer");
  VkMemoryRequirements needs;
  vk.vkGetBufferMemoryRequirements(context->device, buffer, &needs);
  const auto kind = bytes ? vulkan::MemoryKind::Upload : vulkan::MemoryKind::Readback;
  const vulkan::Allocation at = m_memory->allocate(needs, kind, false, desc.label);
  check(vk.vkBindBufferMemory(context->device, buffer, at.memory, at.offset), "vkBindBufferMemory");
  if (bytes) std::memcpy(at.mapped, bytes->data(), bytes->size());
  if (mapped) *mapped = at.mapped;
  return buffer;
}

Objects::Image Objects::createImage(const rhi::TextureDesc& desc) {
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
  check(vk.vkCreateImage(context->device, &info, nullptr, &image.handle), "vkCreateImage");
  VkMemoryRequirements needs;
  vk.vkGetImageMemoryRequirements(context->device, image.handle, &needs);
  const vulkan::Allocation at =
      m_memory->allocate(needs, vulkan::MemoryKind::Device, true, desc.label);
  check(vk.vkBindImageMemory(context->device, image.handle, at.memory, at.offset),
        "vkBindImageMemory");
  const VkImageViewCreateInfo view = {
      .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
      .image = image.handle,
      .viewType = desc.kind == rhi::TextureKind::Tex2DArray ? VK_IMAGE_VIEW_TYPE_2D_ARRAY
                                                            : VK_IMAGE_VIEW_TYPE_2D,
      .format = info.format,
      .subresourceRange = {vulkan::aspectsOf(desc.format), 0, 1, 0, desc.layers}};
  check(vk.vkCreateImageView(context->device, &view, nullptr, &image.view), "vkCreateImageView");
  return image;
}

/// Lookups fetch texels: no filter matters.
VkSampler Objects::createSampler() {
  const VkSamplerCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  VkSampler sampler = VK_NULL_HANDLE;
  check(vk.vkCreateSampler(context->device, &info, nullptr, &sampler), "vkCreateSampler");
  return sampler;
}

void Objects::createSets() {
  const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC, 1024},
                                        {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1024},
                                        {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1024}};
  const VkDescriptorPoolCreateInfo info = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                           .maxSets = 64,
                                           .poolSizeCount = 3,
                                           .pPoolSizes = sizes};
  check(vk.vkCreateDescriptorPool(context->device, &info, nullptr, &m_descriptors),
        "vkCreateDescriptorPool");
  // A set for each pipeline of a pass; its draws differ in offsets alone.
  for (const CapturedPass& pass : capture.passes) {
    IdMap<rhi::PipelineId, VkDescriptorSet> ofPipeline;
    auto& ofPass = sets.emplace_back();
    for (const CapturedDraw& draw : pass.draws) {
      auto [it, isNew] = ofPipeline.try_emplace(draw.pipeline);
      if (isNew) it->second = createSet(draw);
      Set& set = ofPass.emplace_back(Set{it->second, {}});
      for (const auto& [slot, type] : pipelines.at(draw.pipeline).layout->slots)
        if (slot < rhi::kStorageSlotBase)
          set.offsets.push_back(uint32_t(bindingAt(draw, slot).offset));
    }
  }
}

VkDescriptorSet Objects::createSet(const CapturedDraw& draw) {
  const vulkan::PipelineLayout& layout = *pipelines.at(draw.pipeline).layout;
  const VkDescriptorSetAllocateInfo info = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                            .descriptorPool = m_descriptors,
                                            .descriptorSetCount = 1,
                                            .pSetLayouts = &layout.set};
  VkDescriptorSet set = VK_NULL_HANDLE;
  check(vk.vkAllocateDescriptorSets(context->device, &info, &set), "vkAllocateDescriptorSets");
  for (const auto& [slot, type] : layout.slots) {
    const rhi::Binding& b = bindingAt(draw, slot);
    const bool texture = type == VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    VkDescriptorImageInfo image = {};
    VkDescriptorBufferInfo buffer = {};
    if (texture)
      image = {m_samplers.at(b.sampler), images.at(b.view.texture).view, VK_IMAGE_LAYOUT_GENERAL};
    else
      buffer = {buffers.at(b.buffer), 0, b.size == rhi::kWholeSize ? VK_WHOLE_SIZE : b.size};
    const VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                        .dstSet = set,
                                        .dstBinding = slot,
                                        .descriptorCount = 1,
                                        .descriptorType = type,
                                        .pImageInfo = &image,
                                        .pBufferInfo = &buffer};
    vk.vkUpdateDescriptorSets(context->device, 1, &write, 0, nullptr);
  }
  return set;
}

}  // namespace sb::baseline
