// Executes transfers at once on host memory and records every command as a Call.
#pragma once

#include "backends/null/null_backend.h"

namespace null_backend {

class Device;

class CommandList final : public rhi::CommandList {
 public:
  explicit CommandList(Device& device) : m_device(device) {}
  void abandon() { m_pass.clear(); }

 private:
  void doBeginPass(const rhi::PassDesc& desc) override;
  void doEndPass() override;
  void doDraw(const rhi::DrawState& state, const rhi::DrawArgs& args) override;
  void doDrawIndexed(const rhi::DrawState& state,
                     std::span<const rhi::DrawIndexedArgs> draws) override;
  void doDrawIndirect(const rhi::DrawState& state, const rhi::IndirectArgs& args,
                      bool indexed) override;
  void doDispatch(const rhi::DispatchState& state, uint32_t x, uint32_t y, uint32_t z) override;
  void doDispatchIndirect(const rhi::DispatchState& state, rhi::BufferId args,
                          uint64_t offset) override;
  void doWrite(rhi::BufferId buffer, uint64_t offset, std::span<const std::byte> bytes) override;
  void doFill(rhi::BufferId buffer, uint64_t offset, uint64_t size, uint32_t word) override;
  void doCopy(rhi::BufferId source, uint64_t sourceOffset, rhi::BufferId target,
              uint64_t targetOffset, uint64_t size) override;
  void doCopy(const rhi::TextureView& source, const rhi::TextureView& target) override;
  void doTimestamp(rhi::QueryPoolId pool, uint32_t index) override;
  void doBeginQuery(rhi::QueryPoolId pool, uint32_t index) override;
  void doEndQuery(rhi::QueryPoolId pool, uint32_t index) override;

  void record(CallKind kind, const std::string& pipeline, const std::string& resource,
              std::vector<uint64_t> args);

  Device& m_device;
  std::string m_pass;
};

}  // namespace null_backend
