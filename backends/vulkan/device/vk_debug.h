// Carries the validation layer's messages to Device::report.
#pragma once

#include "backends/rhi/device.h"
#include "backends/vulkan/device/vk_instance.h"

namespace vulkan {

class Messenger {
 public:
  /// Without validation there is nothing to listen to, and this does nothing.
  Messenger(const Instance& instance, rhi::Device& sink);
  ~Messenger();
  Messenger(const Messenger&) = delete;
  Messenger& operator=(const Messenger&) = delete;

 private:
  VkInstance m_instance = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT m_messenger = VK_NULL_HANDLE;
};

}  // namespace vulkan
