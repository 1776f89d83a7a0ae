// Watches what is asked of a device, before the backend sees it. Validation is one observer; tests
// and tools may add others. An observer never changes what happens; one that
// throws is as good as a driver that fails there.
#pragma once

#include "backends/rhi/desc.h"

namespace rhi {

class Observer {
 public:
  virtual ~Observer() = default;

  virtual void created(BufferId, const BufferDesc&) {}
  virtual void created(TextureId, const TextureDesc&) {}
  virtual void created(SamplerId, const SamplerDesc&) {}
  virtual void created(PipelineId, const GraphicsPipelineDesc&) {}
  virtual void created(PipelineId, const ComputePipelineDesc&) {}
  virtual void created(QueryPoolId, const QueryPoolDesc&) {}
  virtual void destroyed(BufferId) {}
  virtual void destroyed(TextureId) {}
  virtual void destroyed(SamplerId) {}
  virtual void destroyed(PipelineId) {}
  virtual void destroyed(QueryPoolId) {}

  virtual void beginFrame() {}
  virtual void endFrame() {}
  /// Instead of endFrame, wherever the frame stood: nothing of it is executed or counts.
  virtual void abandonFrame() {}
  virtual void beginPass(const PassDesc&) {}
  virtual void endPass() {}
  virtual void draw(const DrawState&, const DrawArgs&) {}
  virtual void drawIndexed(const DrawState&, const DrawIndexedArgs&) {}
  virtual void drawIndirect(const DrawState&, const IndirectArgs&, bool /*indexed*/) {}
  virtual void dispatch(const DispatchState&, uint32_t, uint32_t, uint32_t) {}
  virtual void dispatchIndirect(const DispatchState&, BufferId, uint64_t) {}
  virtual void write(BufferId, uint64_t /*offset*/, uint64_t /*size*/) {}
  virtual void fill(BufferId, uint64_t /*offset*/, uint64_t /*size*/) {}
  virtual void copy(BufferId, uint64_t, BufferId, uint64_t, uint64_t /*size*/) {}
  virtual void copy(const TextureView&, const TextureView&) {}
  virtual void discard(TextureId) {}
  virtual void timestamp(QueryPoolId, uint32_t) {}
  virtual void beginQuery(QueryPoolId, uint32_t) {}
  virtual void endQuery(QueryPoolId, uint32_t) {}

  /// Outside frames: Device::upload and Device::read.
  virtual void upload(BufferId, uint64_t, uint64_t) {}
  virtual void upload(TextureId, const TextureRegion&, uint64_t /*bytes*/) {}
  virtual void read(BufferId, uint64_t, uint64_t) {}
  virtual void read(TextureId, const TextureRegion&) {}
};

}  // namespace rhi
