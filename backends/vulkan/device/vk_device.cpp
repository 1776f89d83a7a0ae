#include "backends/vulkan/device/vk_device.h"

#include "backends/vulkan/commands/vk_command_list.h"
#include "backends/vulkan/device/vk_formats.h"
#include "backends/vulkan/resources/vk_sampler.h"

namespace vulkan {

Device::Device(std::unique_ptr<Instance> instance, const PhysicalDevice& physical)
    : m_context(std::move(instance), physical),
      m_messenger(m_context.instance(), *this),
      m_memory(m_context),
      m_layouts(m_context),
      m_barriers(m_context),
      m_descriptors(*this),
      m_uploads(m_context, m_memory, MemoryKind::Upload),
      m_readbacks(m_context, m_memory, MemoryKind::Readback),
      m_queue(m_context, m_memory),
      m_list(std::make_unique<CommandList>(*this)) {
  m_info = physical.info;
}

Device::~Device() = default;

rhi::FormatCaps Device::formatCaps(rhi::Format format) const {
  return formatCapsOf(m_context.physical().handle, format);
}
const rhi::BufferDesc& Device::bufferDesc(rhi::BufferId id) const { return m_buffers.get(id).desc; }
const rhi::TextureDesc& Device::textureDesc(rhi::TextureId id) const {
  return m_textures.get(id).desc;
}
const rhi::QueryPoolDesc& Device::queryPoolDesc(rhi::QueryPoolId id) const {
  return m_queryPools.get(id).desc;
}

rhi::BufferId Device::doCreate(const rhi::BufferDesc& desc) {
  return m_buffers.add(vulkan::createBuffer(m_context, m_memory, desc));
}

rhi::TextureId Device::doCreate(const rhi::TextureDesc& desc) {
  const rhi::TextureId id = m_textures.add(vulkan::createTexture(m_context, m_memory, desc));
  m_barriers.created(m_textures.get(id));
  return id;
}

rhi::SamplerId Device::doCreate(const rhi::SamplerDesc& desc) {
  return m_samplers.add(vulkan::createSampler(m_context, desc));
}

rhi::PipelineId Device::doCreate(const rhi::GraphicsPipelineDesc& desc) {
  return m_pipelines.add(vulkan::createPipeline(m_context, m_layouts, desc));
}

rhi::PipelineId Device::doCreate(const rhi::ComputePipelineDesc& desc) {
  return m_pipelines.add(vulkan::createPipeline(m_context, m_layouts, desc));
}

rhi::QueryPoolId Device::doCreate(const rhi::QueryPoolDesc& desc) {
  return m_queryPools.add(vulkan::createQueryPool(m_context, desc));
}

void Device::doDestroy(rhi::BufferId id) {
  m_barriers.forget(m_buffers.get(id));
  m_descriptors.forget(id);
  m_queue.defer(
      [this, buffer = m_buffers.remove(id)] { destroyBuffer(m_context, m_memory, buffer); });
}

void Device::doDestroy(rhi::TextureId id) {
  m_barriers.forget(m_textures.get(id));
  m_descriptors.forget(id);
  m_queue.defer(
      [this, texture = m_textures.remove(id)] { destroyTexture(m_context, m_memory, texture); });
}

void Device::doDestroy(rhi::SamplerId id) {
  m_descriptors.forget(id);
  m_queue.defer([this, sampler = m_samplers.remove(id)] {
    m_context.vk.vkDestroySampler(m_context.device, sampler, nullptr);
  });
}

void Device::doDestroy(rhi::PipelineId id) {
  m_queue.defer([this, pipeline = m_pipelines.remove(id)] {
    m_context.vk.vkDestroyPipeline(m_context.device, pipeline.handle, nullptr);
  });
}

void Device::doDestroy(rhi::QueryPoolId id) {
  m_queue.defer([this, pool = m_queryPools.remove(id)] {
    m_context.vk.vkDestroyQueryPool(m_context.device, pool.handle, nullptr);
  });
}

rhi::CommandList& Device::doBeginFrame() {
  m_queue.beginFrame();
  m_barriers.beginFrame();
  m_list->begin();
  return *m_list;
}

rhi::Ticket Device::doEndFrame() {
  m_list->end();
  const rhi::Ticket ticket = m_queue.endFrame();
  m_barriers.endFrame();
  m_descriptors.endFrame();
  return ticket;
}

void Device::doAbandonFrame() {
  m_queue.abandonFrame();
  m_barriers.abandonFrame();
}

void Device::doWait(rhi::Ticket ticket) { m_queue.wait(ticket); }
void Device::doWaitIdle() { m_queue.waitIdle(); }

void Device::doReadQueries(rhi::QueryPoolId pool, uint32_t first, uint32_t count,
                           std::span<uint64_t> out) {
  vulkan::readQueries(m_context, m_queryPools.get(pool), first, count, out);
}

}  // namespace vulkan
