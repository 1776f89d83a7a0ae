// The RHI's own validation. Drivers are silent about much that is wrong (facts.md), so this checks
// the contract of the interface itself: that passes declare what they touch, that bindings fit the
// shaders, that ranges lie inside. Findings go to Device::report with source "rhi" and the rule's
// name; the same finding is reported once a frame. Rules stand in rules_*.cpp, one function each.
#pragma once

#include <memory>
#include <set>

#include "backends/rhi/device.h"
#include "backends/rhi/observer.h"

namespace rhi {

namespace validate {
struct State;
struct DrawCheck;
struct TransferCheck;
struct QueryCheck;
struct Finding;
}  // namespace validate

class Validator : public Observer {
 public:
  /// Attaches itself. Create it before any object of the device and destroy it before the device.
  explicit Validator(Device& device);
  ~Validator() override;
  Validator(const Validator&) = delete;
  Validator& operator=(const Validator&) = delete;

  void created(BufferId id, const BufferDesc& desc) override;
  void created(TextureId id, const TextureDesc& desc) override;
  void created(SamplerId id, const SamplerDesc& desc) override;
  void created(PipelineId id, const GraphicsPipelineDesc& desc) override;
  void created(PipelineId id, const ComputePipelineDesc& desc) override;
  void created(QueryPoolId id, const QueryPoolDesc& desc) override;
  void destroyed(BufferId id) override;
  void destroyed(TextureId id) override;
  void destroyed(SamplerId id) override;
  void destroyed(PipelineId id) override;
  void destroyed(QueryPoolId id) override;

  void beginFrame() override;
  void abandonFrame() override;
  void beginPass(const PassDesc& desc) override;
  void endPass() override;
  void draw(const DrawState& state, const DrawArgs& args) override;
  void drawIndexed(const DrawState& state, const DrawIndexedArgs& args) override;
  void drawIndirect(const DrawState& state, const IndirectArgs& args, bool indexed) override;
  void dispatch(const DispatchState& state, uint32_t x, uint32_t y, uint32_t z) override;
  void dispatchIndirect(const DispatchState& state, BufferId args, uint64_t offset) override;
  void write(BufferId buffer, uint64_t offset, uint64_t size) override;
  void fill(BufferId buffer, uint64_t offset, uint64_t size) override;
  void copy(BufferId source, uint64_t sourceOffset, BufferId target, uint64_t targetOffset,
            uint64_t size) override;
  void copy(const TextureView& source, const TextureView& target) override;
  void discard(TextureId texture) override;
  void timestamp(QueryPoolId pool, uint32_t index) override;
  void beginQuery(QueryPoolId pool, uint32_t index) override;
  void endQuery(QueryPoolId pool, uint32_t index) override;
  void upload(BufferId buffer, uint64_t offset, uint64_t size) override;
  void upload(TextureId texture, const TextureRegion& region, uint64_t bytes) override;
  void read(BufferId buffer, uint64_t offset, uint64_t size) override;
  void read(TextureId texture, const TextureRegion& region) override;

 private:
  void run(validate::DrawCheck check);
  void run(const validate::TransferCheck& check);
  void run(const validate::QueryCheck& check);
  void report(const std::vector<validate::Finding>& findings);

  Device& m_device;
  std::unique_ptr<validate::State> m_state;
  std::set<std::pair<std::string_view, std::string>> m_reported;  // in this frame
};

}  // namespace rhi
