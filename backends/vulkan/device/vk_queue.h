// Submission: the frames in flight (command buffers, staging memory), a timeline semaphore whose
// value is the ticket of the last finished frame, blocking one-off submissions, and the destruction
// of objects once no frame uses them.
#pragma once

#include <deque>
#include <functional>
#include <memory>

#include "backends/rhi/device.h"
#include "backends/vulkan/resources/vk_staging.h"

namespace vulkan {

class Queue {
 public:
  Queue(const Context& context, Memory& memory);
  ~Queue();
  Queue(const Queue&) = delete;
  Queue& operator=(const Queue&) = delete;

  /// Waits until a frame's storage is free and begins recording it.
  void beginFrame();
  rhi::Ticket endFrame();
  /// What was recorded is thrown away when the frame's storage is used again.
  void abandonFrame() { m_recording = false; }
  /// Of the frame under construction. `prologue` runs before `commands`: query resets, which must
  /// not stand inside a pass, go there.
  VkCommandBuffer commands() const { return m_frames[m_current].commands; }
  VkCommandBuffer prologue();
  Staging& staging() { return *m_frames[m_current].staging; }

  void wait(rhi::Ticket ticket);
  void waitIdle();

  /// Records, submits and waits. Outside frames.
  void immediate(const std::function<void(VkCommandBuffer)>& record);

  /// Runs `destroy` when all work that may use the object is finished.
  void defer(std::function<void()> destroy);

 private:
  struct Frame {
    VkCommandPool pool = VK_NULL_HANDLE;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkCommandBuffer prologue = VK_NULL_HANDLE;
    bool hasPrologue = false;
    std::unique_ptr<Staging> staging;
    rhi::Ticket ticket = 0;
  };
  void begin(VkCommandBuffer commands);
  void create(Frame& frame, const char* label);
  void runDeferred();

  const Context& m_context;
  std::array<Frame, rhi::kFramesInFlight> m_frames;
  Frame m_immediate;
  VkFence m_fence = VK_NULL_HANDLE;
  VkSemaphore m_timeline = VK_NULL_HANDLE;
  size_t m_current = 0;
  bool m_recording = false;
  rhi::Ticket m_submitted = 0;
  std::deque<std::pair<rhi::Ticket, std::function<void()>>> m_deferred;
};

}  // namespace vulkan
