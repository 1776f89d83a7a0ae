// The device without a driver.
#pragma once

#include "backends/null/null_backend.h"
#include "backends/null/null_command_list.h"
#include "backends/null/null_memory.h"
#include "backends/rhi/pool.h"

namespace null_backend {

class Device final : public rhi::Device {
 public:
  explicit Device(rhi::DeviceInfo info);

  rhi::FormatCaps formatCaps(rhi::Format format) const override;
  const rhi::BufferDesc& bufferDesc(rhi::BufferId id) const override;
  const rhi::TextureDesc& textureDesc(rhi::TextureId id) const override;
  const rhi::QueryPoolDesc& queryPoolDesc(rhi::QueryPoolId id) const override;

  Buffer& buffer(rhi::BufferId id) { return m_buffers.get(id); }
  Texture& texture(rhi::TextureId id) { return m_textures.get(id); }
  const std::string& label(rhi::PipelineId id) const { return m_pipelines.get(id); }
  void stamp(rhi::QueryPoolId pool, uint32_t index);
  void record(Call call) { m_calls.push_back(std::move(call)); }
  const std::vector<Call>& calls() const { return m_calls; }
  void clearCalls() { m_calls.clear(); }

 private:
  struct QueryPool {
    rhi::QueryPoolDesc desc;
    std::vector<uint64_t> values;
  };

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
  rhi::CommandList& doBeginFrame() override { return m_list; }
  rhi::Ticket doEndFrame() override { return ++m_ticket; }
  void doAbandonFrame() override { m_list.abandon(); }
  void doWait(rhi::Ticket) override {}  // every frame is finished when it ends
  void doWaitIdle() override {}
  void doReadQueries(rhi::QueryPoolId pool, uint32_t first, uint32_t count,
                     std::span<uint64_t> out) override;

  CommandList m_list{*this};
  std::vector<Call> m_calls;
  rhi::Ticket m_ticket = 0;
  uint64_t m_clock = 0;
  rhi::Pool<rhi::BufferTag, Buffer> m_buffers;
  rhi::Pool<rhi::TextureTag, Texture> m_textures;
  rhi::Pool<rhi::SamplerTag, std::string> m_samplers;    // the labels
  rhi::Pool<rhi::PipelineTag, std::string> m_pipelines;  // the labels
  rhi::Pool<rhi::QueryPoolTag, QueryPool> m_queryPools;
};

}  // namespace null_backend
