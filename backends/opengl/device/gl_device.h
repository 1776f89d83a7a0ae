// An OpenGL device: one context and everything that lives in it.
#pragma once

#include <deque>
#include <memory>

#include "backends/opengl/commands/gl_command_list.h"
#include "backends/rhi/device.h"

namespace opengl {

class Device : public rhi::Device {
 public:
  /// `info` was queried from `context`.
  Device(std::unique_ptr<Context> context, rhi::DeviceInfo info, bool validate);
  ~Device() override;

  rhi::FormatCaps formatCaps(rhi::Format format) const override;
  const rhi::BufferDesc& bufferDesc(rhi::BufferId id) const override;
  const rhi::TextureDesc& textureDesc(rhi::TextureId id) const override;
  const rhi::QueryPoolDesc& queryPoolDesc(rhi::QueryPoolId id) const override;

 protected:
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

 private:
  struct Frame {
    rhi::Ticket ticket = 0;
    GLsync fence = nullptr;
  };
  void finishOldest();

  std::unique_ptr<Context> m_context;  // first: everything below is deleted while it is current
  Objects m_objects;
  State m_state;
  FramebufferCache m_framebuffers;
  Barriers m_barriers;
  CommandList m_commands;
  std::deque<Frame> m_inFlight;
  rhi::Ticket m_lastTicket = 0;
};

}  // namespace opengl
