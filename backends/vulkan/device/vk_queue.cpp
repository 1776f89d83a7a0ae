#include "backends/vulkan/device/vk_queue.h"

#include <cassert>

namespace vulkan {

Queue::Queue(const Context& context, Memory& memory) : m_context(context) {
  const VkSemaphoreTypeCreateInfo type = {
      .sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO,
      .semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE,
  };
  const VkSemaphoreCreateInfo info = {.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO,
                                      .pNext = &type};
  check(m_context.vk.vkCreateSemaphore(m_context.device, &info, nullptr, &m_timeline),
        "vkCreateSemaphore");
  const VkFenceCreateInfo fence = {.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  check(m_context.vk.vkCreateFence(m_context.device, &fence, nullptr, &m_fence), "vkCreateFence");
  for (Frame& frame : m_frames) {
    create(frame, "frame");
    frame.staging = std::make_unique<Staging>(context, memory, MemoryKind::Upload);
  }
  create(m_immediate, "immediate");
}

Queue::~Queue() {
  // A lost device cannot be waited for, and its objects may be destroyed all the same.
  m_context.vk.vkDeviceWaitIdle(m_context.device);
  for (auto& [ticket, destroy] : m_deferred) destroy();
  for (Frame& frame : m_frames)
    m_context.vk.vkDestroyCommandPool(m_context.device, frame.pool, nullptr);
  m_context.vk.vkDestroyCommandPool(m_context.device, m_immediate.pool, nullptr);
  m_context.vk.vkDestroyFence(m_context.device, m_fence, nullptr);
  m_context.vk.vkDestroySemaphore(m_context.device, m_timeline, nullptr);
}

void Queue::create(Frame& frame, const char* label) {
  const VkCommandPoolCreateInfo pool = {
      .sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
      .flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT,
      .queueFamilyIndex = m_context.physical().queueFamily,
  };
  check(m_context.vk.vkCreateCommandPool(m_context.device, &pool, nullptr, &frame.pool),
        "vkCreateCommandPool", label);
  VkCommandBuffer buffers[2];
  const VkCommandBufferAllocateInfo info = {
      .sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
      .commandPool = frame.pool,
      .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
      .commandBufferCount = 2,
  };
  check(m_context.vk.vkAllocateCommandBuffers(m_context.device, &info, buffers),
        "vkAllocateCommandBuffers", label);
  frame.commands = buffers[0];
  frame.prologue = buffers[1];
  m_context.name(frame.commands, VK_OBJECT_TYPE_COMMAND_BUFFER, label);
}

void Queue::begin(VkCommandBuffer commands) {
  const VkCommandBufferBeginInfo info = {
      .sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
      .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT,
  };
  check(m_context.vk.vkBeginCommandBuffer(commands, &info), "vkBeginCommandBuffer");
}

void Queue::beginFrame() {
  m_current = (m_current + 1) % m_frames.size();
  Frame& frame = m_frames[m_current];
  wait(frame.ticket);
  check(m_context.vk.vkResetCommandPool(m_context.device, frame.pool, 0), "vkResetCommandPool");
  frame.staging->reset();
  frame.hasPrologue = false;
  begin(frame.commands);
  m_recording = true;
}

VkCommandBuffer Queue::prologue() {
  Frame& frame = m_frames[m_current];
  if (!frame.hasPrologue) begin(frame.prologue);
  frame.hasPrologue = true;
  return frame.prologue;
}

rhi::Ticket Queue::endFrame() {
  Frame& frame = m_frames[m_current];
  VkCommandBufferSubmitInfo buffers[2];
  uint32_t count = 0;
  auto add = [&](VkCommandBuffer commands) {
    check(m_context.vk.vkEndCommandBuffer(commands), "vkEndCommandBuffer");
    buffers[count++] = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                        .commandBuffer = commands};
  };
  if (frame.hasPrologue) add(frame.prologue);
  add(frame.commands);
  const VkSemaphoreSubmitInfo signal = {
      .sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO,
      .semaphore = m_timeline,
      .value = m_submitted + 1,
      .stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
  };
  const VkSubmitInfo2 submit = {
      .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
      .commandBufferInfoCount = count,
      .pCommandBufferInfos = buffers,
      .signalSemaphoreInfoCount = 1,
      .pSignalSemaphoreInfos = &signal,
  };
  m_recording = false;
  check(m_context.vk.vkQueueSubmit2(m_context.queue, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit2");
  return frame.ticket = ++m_submitted;
}

void Queue::wait(rhi::Ticket ticket) {
  assert(ticket <= m_submitted);
  if (ticket > 0) {
    const VkSemaphoreWaitInfo info = {
        .sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO,
        .semaphoreCount = 1,
        .pSemaphores = &m_timeline,
        .pValues = &ticket,
    };
    check(m_context.vk.vkWaitSemaphores(m_context.device, &info, UINT64_MAX), "vkWaitSemaphores");
  }
  runDeferred();
}

void Queue::waitIdle() { wait(m_submitted); }

void Queue::immediate(const std::function<void(VkCommandBuffer)>& record) {
  assert(!m_recording);
  check(m_context.vk.vkResetCommandPool(m_context.device, m_immediate.pool, 0),
        "vkResetCommandPool");
  begin(m_immediate.commands);
  record(m_immediate.commands);
  check(m_context.vk.vkEndCommandBuffer(m_immediate.commands), "vkEndCommandBuffer");
  const VkCommandBufferSubmitInfo buffer = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                            .commandBuffer = m_immediate.commands};
  const VkSubmitInfo2 submit = {
      .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
      .commandBufferInfoCount = 1,
      .pCommandBufferInfos = &buffer,
  };
  check(m_context.vk.vkQueueSubmit2(m_context.queue, 1, &submit, m_fence), "vkQueueSubmit2");
  check(m_context.vk.vkWaitForFences(m_context.device, 1, &m_fence, VK_TRUE, UINT64_MAX),
        "vkWaitForFences");
  check(m_context.vk.vkResetFences(m_context.device, 1, &m_fence), "vkResetFences");
}

void Queue::defer(std::function<void()> destroy) {
  m_deferred.emplace_back(m_submitted + (m_recording ? 1 : 0), std::move(destroy));
}

void Queue::runDeferred() {
  if (m_deferred.empty()) return;
  rhi::Ticket done = 0;
  check(m_context.vk.vkGetSemaphoreCounterValue(m_context.device, m_timeline, &done),
        "vkGetSemaphoreCounterValue");
  while (!m_deferred.empty() && m_deferred.front().first <= done) {
    auto destroy = std::move(m_deferred.front().second);
    m_deferred.pop_front();
    destroy();
  }
}

}  // namespace vulkan
