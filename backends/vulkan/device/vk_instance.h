// A VkInstance, loaded through volk. With `validate`, the Khronos validation layer with
// synchronization checks is part of it, or the constructor throws.
#pragma once

#include "backends/vulkan/device/vk_common.h"

namespace vulkan {

class Instance {
 public:
  explicit Instance(bool validate);
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  VkInstance handle() const { return m_instance; }
  /// VK_EXT_debug_utils is enabled: labels and names reach debuggers.
  bool debugUtils() const { return m_debugUtils; }
  bool validates() const { return m_validate; }

 private:
  VkInstance m_instance = VK_NULL_HANDLE;
  bool m_debugUtils = false;
  bool m_validate = false;
};

}  // namespace vulkan
