// The device: owns every object by id and the machinery around them. Transfers outside frames are
// in vk_transfer.cpp.
#pragma once

#include <memory>

#include "backends/rhi/device.h"
#include "backends/rhi/pool.h"
#include "backends/vulkan/commands/vk_barriers.h"
#include "backends/vulkan/device/vk_debug.h"
#include "backends/vulkan/device/vk_queue.h"
#include "backends/vulkan/pipeline/vk_descriptors.h"
#include "backends/vulkan/pipeline/vk_pipeline.h"
#include "backends/vulkan/resources/vk_query.h"

namespace vulkan {

class CommandList;

class Device final : public rhi::Device {
 public:
  Device(std::unique_ptr<Instance> instance, const PhysicalDevice& physical);
  ~Device() override;

  rhi::FormatCaps formatCaps(rhi::Format format) const override;
  const rhi::BufferDesc& bufferDesc(rhi::BufferId id) const override;
  const rhi::TextureDesc& textureDesc(rhi::TextureId id) const override;
  const rhi::QueryPoolDesc& queryPoolDesc(rhi::QueryPoolId id) const override;

  const Context& context() const { return m_context; }
  Queue& queue() { return m_queue; }
  Barriers& barriers() { return m_barriers; }
  Descriptors& descriptors() { return m_descriptors; }
  Buffer& get(rhi::BufferId id) { return m_buffers.get(id); }
  Texture& get(rhi::TextureId id) { return m_textures.get(id); }
  VkSampler get(rhi::SamplerId id) { return m_samplers.get(id); }
  const Pipeline& get(rhi::PipelineId id) { return m_pipelines.get(id); }
  QueryPool& get(rhi::QueryPoolId id) { return m_queryPools.get(id); }

 private:
  rhi::BufferId doCreate(const rhi::BufferDesc& desc) override;
  rhi::TextureId doCreate(const rhi::TextureDesc& desc) override;
  rhi::SamplerId doCreate(const rhi::SamplerDesc& desc) override;
  rhi::PipelineId doCreate(const rhi::GraphicsPipelineDesc& desc) override;
  rhi::PipelineId doCreate(const rhi::ComputePipelineDesc& desc) override;
  rhi::QueryPoolId doCreate(const rhi::QueryPoolDesc& desc) override;
  void doDestroy(rhi::BufferId id) override;
  void doDestroy(rhi::TextureId id) override;
  void doDestroy(rhi::SamplerId id) override;
  void doDestroy(rhi::PipelineId id) override;
  void doDestroy(rhi::QueryPoolId id) override;
  void doUpload(rhi::BufferId buffer, uint64_t offset, std::span<const std::byte> bytes) override;
  void doUpload(rhi::TextureId texture, const rhi::TextureRegion& region,
                std::span<const std::byte> bytes) override;
  void doRead(rhi::BufferId buffer, uint64_t offset, std::span<std::byte> out) override;
  void doRead(rhi::TextureId texture, const rhi::TextureRegion& region, rhi::Aspect aspect,
              std::span<std::byte> out) override;
  rhi::CommandList& doBeginFrame() override;
  rhi::Ticket doEndFrame() override;
  void doAbandonFrame() override;
  void doWait(rhi::Ticket ticket) override;
  void doWaitIdle() override;
  void doReadQueries(rhi::QueryPoolId pool, uint32_t first, uint32_t count,
                     std::span<uint64_t> out) override;

  // In the order of construction; destruction runs backwards, deferred objects go with m_queue
  // before their memory.
  Context m_context;
  Messenger m_messenger;
  Memory m_memory;
  PipelineLayouts m_layouts;
  Barriers m_barriers;
  rhi::Pool<rhi::BufferTag, Buffer> m_buffers;
  rhi::Pool<rhi::TextureTag, Texture> m_textures;
  rhi::Pool<rhi::SamplerTag, VkSampler> m_samplers;
  rhi::Pool<rhi::PipelineTag, Pipeline> m_pipelines;
  rhi::Pool<rhi::QueryPoolTag, QueryPool> m_queryPools;
  Descriptors m_descriptors;
  Staging m_uploads;
  Staging m_readbacks;
  Queue m_queue;
  std::unique_ptr<CommandList> m_list;
};

}  // namespace vulkan
