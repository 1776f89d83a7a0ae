// Recording of one frame. Public functions count and report to the device's observer (validation,
// recording); the do* functions are what a backend implements.
#pragma once

#include <cstddef>
#include <exception>
#include <span>
#include <utility>

#include "backends/rhi/desc.h"

namespace rhi {

class CommandList;
class Observer;

/// What a frame executed, counted in the interface and so the same for every backend.
struct Counters {
  uint64_t passes = 0;      ///< graphics and compute passes
  uint64_t draws = 0;       ///< draw calls (indirect: its drawCount)
  uint64_t dispatches = 0;
  uint64_t triangles = 0;   ///< input triangles of direct draws, all instances
  bool operator==(const Counters&) const = default;
};
Counters operator-(const Counters& a, const Counters& b);

/// Ends its pass when it goes out of scope.
class [[nodiscard]] PassScope {
 public:
  explicit PassScope(CommandList* list) : m_list(list) {}
  PassScope(PassScope&& other) noexcept
      : m_list(std::exchange(other.m_list, nullptr)), m_exceptions(other.m_exceptions) {}
  PassScope& operator=(PassScope&&) = delete;
  /// While an exception unwinds, the pass is left: its frame will be abandoned.
  ~PassScope() noexcept(false);
  void end();

 private:
  CommandList* m_list;
  int m_exceptions = std::uncaught_exceptions();
};

/// Owned by the device; valid between Device::beginFrame and Device::endFrame. Draws and dispatches
/// happen inside a pass; writes, copies and timestamps outside.
class CommandList {
 public:
  virtual ~CommandList() = default;

  /// Vulkan: barriers from the declared uses, then vkCmdBeginRendering. GL: memory barrier bits, a
  /// cached framebuffer, clears.
  PassScope beginPass(const PassDesc& desc);
  void endPass();

  /// Vulkan: vkCmdDraw*. GL: glDraw*Instanced*.
  void draw(const DrawState& state, const DrawArgs& args);
  void drawIndexed(const DrawState& state, const DrawIndexedArgs& args) {
    drawIndexed(state, std::span(&args, 1));
  }
  /// Draws that share all state, in order. Those of the same indices whose instances follow one
  /// another reach the driver as one.
  void drawIndexed(const DrawState& state, std::span<const DrawIndexedArgs> draws);
  /// Vulkan: vkCmdDraw(Indexed)Indirect. GL: glMultiDraw*Indirect.
  void drawIndirect(const DrawState& state, const IndirectArgs& args);
  void drawIndexedIndirect(const DrawState& state, const IndirectArgs& args);
  void dispatch(const DispatchState& state, uint32_t x, uint32_t y = 1, uint32_t z = 1);
  void dispatchIndirect(const DispatchState& state, BufferId args, uint64_t offset = 0);

  /// Copies host bytes into a buffer, in order with the passes around it; none of them, nothing.
  /// Vulkan: staging ring and vkCmdCopyBuffer. GL: glNamedBufferSubData.
  void write(BufferId buffer, uint64_t offset, std::span<const std::byte> bytes);
  /// Fills with a repeated 32-bit word; offset and size are multiples of 4.
  void fill(BufferId buffer, uint64_t offset, uint64_t size, uint32_t word);
  void copy(BufferId source, uint64_t sourceOffset, BufferId target, uint64_t targetOffset,
            uint64_t size);
  /// Same format, extent and sample count; all mips and layers of both views.
  void copy(const TextureView& source, const TextureView& target);
  /// Nothing reads what a texture holds before it is written again. Vulkan, GL: nothing; validation
  /// holds it to be true.
  void discard(TextureId texture);

  /// Stamps the time at which everything before it has finished, and lets nothing after it start
  /// before (facts.md: without a full barrier a stamp says nothing). Outside passes. Vulkan:
  /// barrier, vkCmdWriteTimestamp2 at the bottom, barrier. GL on software: glFinish and
  /// GL_TIMESTAMP; else glQueryCounter.
  void timestamp(QueryPoolId pool, uint32_t index);
  /// Occlusion (exact sample count) or pipeline statistics, inside one pass.
  void beginQuery(QueryPoolId pool, uint32_t index);
  void endQuery(QueryPoolId pool, uint32_t index);

  const Counters& counters() const { return m_counters; }
  bool inPass() const { return m_inPass; }

 protected:
  explicit CommandList(Observer* observer = nullptr) : m_observer(observer) {}
  friend class Device;

  virtual void doBeginPass(const PassDesc& desc) = 0;
  virtual void doEndPass() = 0;
  virtual void doDraw(const DrawState& state, const DrawArgs& args) = 0;
  virtual void doDrawIndexed(const DrawState& state, std::span<const DrawIndexedArgs> draws) = 0;
  virtual void doDrawIndirect(const DrawState& state, const IndirectArgs& args, bool indexed) = 0;
  virtual void doDispatch(const DispatchState& state, uint32_t x, uint32_t y, uint32_t z) = 0;
  virtual void doDispatchIndirect(const DispatchState& state, BufferId args, uint64_t offset) = 0;
  virtual void doWrite(BufferId buffer, uint64_t offset, std::span<const std::byte> bytes) = 0;
  virtual void doFill(BufferId buffer, uint64_t offset, uint64_t size, uint32_t word) = 0;
  virtual void doCopy(BufferId source, uint64_t sourceOffset, BufferId target,
                      uint64_t targetOffset, uint64_t size) = 0;
  virtual void doCopy(const TextureView& source, const TextureView& target) = 0;
  virtual void doTimestamp(QueryPoolId pool, uint32_t index) = 0;
  virtual void doBeginQuery(QueryPoolId pool, uint32_t index) = 0;
  virtual void doEndQuery(QueryPoolId pool, uint32_t index) = 0;

 private:
  Counters m_counters;
  Observer* m_observer = nullptr;
  bool m_inPass = false;
  std::vector<DrawIndexedArgs> m_joined;  // kept to spare allocations
};

}  // namespace rhi
