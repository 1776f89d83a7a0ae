// A device of one API: creates objects, records and submits frames, reads results back.
// Public functions keep the ledger (memory by label, what is alive) and tell the observer; the do*
// functions are what a backend implements. Not thread-safe: one thread per device.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "backends/rhi/command_list.h"
#include "backends/rhi/device_info.h"
#include "backends/rhi/error.h"
#include "backends/rhi/ledger.h"
#include "backends/rhi/observer.h"

namespace rhi {

/// A message of the driver's validation, of GL's debug output, or of the RHI's own validation.
/// Any message is a defect of the program (or worth a line in facts.md): tests fail on it.
struct Message {
  std::string source;  ///< "vulkan", "opengl", "rhi"
  std::string rule;    ///< the driver's id of the message or the name of the RHI's rule
  std::string text;
};

/// Identifies submitted work; tickets of a device grow by one a frame.
using Ticket = uint64_t;

/// What a window or an off-screen presentation target would be made from. Interface only for now:
/// no backend reports Feature::Presentation yet.
struct SurfaceDesc {
  std::string label;
  void* nativeDisplay = nullptr;
  uintptr_t nativeWindow = 0;
  Extent2D extent;
  bool vsync = false;
};
/// Presents a texture to a window at the end of a frame.
class Surface {
 public:
  virtual ~Surface() = default;
  virtual Extent2D extent() const = 0;
  virtual void resize(Extent2D extent) = 0;
  virtual void present(TextureId source) = 0;
};

class Device {
 public:
  virtual ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  const DeviceInfo& info() const { return m_info; }
  bool supports(Feature feature) const { return m_info.features.contains(feature); }
  /// A device that computes on the CPU: its times are never "GPU time".
  bool isSoftware() const { return m_info.type == DeviceType::Software; }
  virtual FormatCaps formatCaps(Format format) const = 0;

  // Creation. Throws Error (with the label) when the driver refuses; contents are undefined.
  Buffer createBuffer(const BufferDesc& desc);
  Texture createTexture(const TextureDesc& desc);
  Sampler createSampler(const SamplerDesc& desc);
  Pipeline createPipeline(const GraphicsPipelineDesc& desc);
  Pipeline createPipeline(const ComputePipelineDesc& desc);
  QueryPool createQueryPool(const QueryPoolDesc& desc);
  void destroy(BufferId id);
  void destroy(TextureId id);
  void destroy(SamplerId id);
  void destroy(PipelineId id);
  void destroy(QueryPoolId id);

  /// Blocking transfers outside frames. `bytes` of a texture are tightly packed rows, row 0 first
  /// (hostTexelBytes per texel). No bytes for a buffer: nothing. Reads wait for all submitted work.
  void upload(BufferId buffer, uint64_t offset, std::span<const std::byte> bytes);
  void upload(TextureId texture, const TextureRegion& region, std::span<const std::byte> bytes);
  std::vector<std::byte> read(BufferId buffer, uint64_t offset, uint64_t size);
  std::vector<std::byte> read(TextureId texture, const TextureRegion& region = {},
                              Aspect aspect = Aspect::Color);

  /// One frame at a time. beginFrame waits until at most kFramesInFlight - 1 frames are unfinished.
  CommandList& beginFrame();
  Ticket endFrame();
  /// Gives up the frame that is being recorded, wherever it stands: after an exception. What was
  /// recorded is not executed, or (OpenGL executes at once) is finished in an orderly way; the next
  /// frame starts as if this one had not been begun. Without a frame, does nothing.
  void abandonFrame() noexcept;
  void wait(Ticket ticket);
  void waitIdle();

  /// Results of queries whose frames are finished. Timestamps in ticks, for elapsedNs (timestamp.h)
  /// alone; occlusion in samples;
  /// pipeline statistics as 7 values a query: input vertices, input primitives, vertex invocations,
  /// clipping invocations, clipping primitives, fragment invocations, compute invocations.
  std::vector<uint64_t> readQueries(QueryPoolId pool, uint32_t first, uint32_t count);
  static constexpr uint32_t kStatisticsValues = 7;

  /// Throws Error where Feature::Presentation is absent.
  virtual std::unique_ptr<Surface> createSurface(const SurfaceDesc& desc);

  /// Everything reported since the last call; empties the store.
  std::vector<Message> takeMessages();
  void report(Message message);
  /// At most one observer, not owned; null removes it. Set it before anything is created.
  void setObserver(Observer* observer);
  Observer* observer() const { return m_observer; }

  const Ledger& ledger() const { return m_ledger; }
  /// The description an object was created from.
  virtual const BufferDesc& bufferDesc(BufferId id) const = 0;
  virtual const TextureDesc& textureDesc(TextureId id) const = 0;
  virtual const QueryPoolDesc& queryPoolDesc(QueryPoolId id) const = 0;

 protected:
  Device() = default;
  DeviceInfo m_info;

  virtual BufferId doCreate(const BufferDesc& desc) = 0;
  virtual TextureId doCreate(const TextureDesc& desc) = 0;
  virtual SamplerId doCreate(const SamplerDesc& desc) = 0;
  virtual PipelineId doCreate(const GraphicsPipelineDesc& desc) = 0;
  virtual PipelineId doCreate(const ComputePipelineDesc& desc) = 0;
  virtual QueryPoolId doCreate(const QueryPoolDesc& desc) = 0;
  virtual void doDestroy(BufferId id) = 0;
  virtual void doDestroy(TextureId id) = 0;
  virtual void doDestroy(SamplerId id) = 0;
  virtual void doDestroy(PipelineId id) = 0;
  virtual void doDestroy(QueryPoolId id) = 0;
  virtual void doUpload(BufferId buffer, uint64_t offset, std::span<const std::byte> bytes) = 0;
  virtual void doUpload(TextureId texture, const TextureRegion& region,
                        std::span<const std::byte> bytes) = 0;
  virtual void doRead(BufferId buffer, uint64_t offset, std::span<std::byte> out) = 0;
  virtual void doRead(TextureId texture, const TextureRegion& region, Aspect aspect,
                      std::span<std::byte> out) = 0;
  virtual CommandList& doBeginFrame() = 0;
  virtual Ticket doEndFrame() = 0;
  virtual void doAbandonFrame() = 0;
  virtual void doWait(Ticket ticket) = 0;
  virtual void doWaitIdle() = 0;
  virtual void doReadQueries(QueryPoolId pool, uint32_t first, uint32_t count,
                             std::span<uint64_t> out) = 0;

 private:
  CommandList* m_frame = nullptr;
  Observer* m_observer = nullptr;
  Ledger m_ledger;
  std::vector<Message> m_messages;
};

/// A frame that is abandoned unless it was ended.
class FrameScope {
 public:
  explicit FrameScope(Device& device) : m_device(device), m_commands(device.beginFrame()) {}
  FrameScope(const FrameScope&) = delete;
  FrameScope& operator=(const FrameScope&) = delete;
  ~FrameScope() {
    if (!m_ended) m_device.abandonFrame();
  }
  CommandList& commands() const { return m_commands; }
  Ticket end() {
    const Ticket ticket = m_device.endFrame();
    m_ended = true;
    return ticket;
  }
  /// Until it is executed.
  void endAndWait() { m_device.wait(end()); }

 private:
  Device& m_device;
  CommandList& m_commands;
  bool m_ended = false;
};

template <class Tag>
void Handle<Tag>::reset() {
  if (m_id) m_device->destroy(m_id);
  m_device = nullptr;
  m_id = {};
}

/// How a device is opened.
struct DeviceRequest {
  std::string selector;   ///< see chooseDevice
  bool validate = false;  ///< the driver's validation (Vulkan layer with synchronization checks, GL
                          ///< debug output); its messages arrive in Device::takeMessages
};

/// One API with one way to reach it ("vulkan", "opengl", "opengl-osmesa", "null").
class Backend {
 public:
  virtual ~Backend() = default;
  virtual std::string_view name() const = 0;
  /// Throws Error when there is no loader or no driver, with the reason for people.
  virtual std::vector<DeviceInfo> enumerate() = 0;
  /// Drivers that are installed and do not load, each with the reason.
  virtual std::vector<std::string> troubles() { return {}; }
  virtual std::unique_ptr<Device> open(const DeviceRequest& request) = 0;
};

}  // namespace rhi
