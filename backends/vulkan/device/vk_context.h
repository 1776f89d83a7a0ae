// The opened VkDevice and what belongs to it for life: function table, queue, names. Every other
// object of the backend holds a reference to it.
#pragma once

#include <memory>

#include "backends/vulkan/device/vk_device_info.h"

namespace vulkan {

class Context {
 public:
  Context(std::unique_ptr<Instance> instance, const PhysicalDevice& physical);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  const Instance& instance() const { return *m_instance; }
  const PhysicalDevice& physical() const { return m_physical; }
  const VkPhysicalDeviceFeatures& features() const { return m_physical.features.core.features; }
  const VkPhysicalDeviceLimits& limits() const { return m_physical.properties.limits; }

  VkDevice device = VK_NULL_HANDLE;
  VkQueue queue = VK_NULL_HANDLE;
  VkPipelineCache pipelineCache = VK_NULL_HANDLE;
  VolkDeviceTable vk = {};
  PFN_vkCmdBeginDebugUtilsLabelEXT cmdBeginLabel = nullptr;  ///< null without VK_EXT_debug_utils
  PFN_vkCmdEndDebugUtilsLabelEXT cmdEndLabel = nullptr;

  /// Gives an object the label that debuggers and validation messages show.
  template <class H>
  void name(H handle, VkObjectType type, const std::string& label) const {
    setName(type, uint64_t(handle), label);
  }

 private:
  void setName(VkObjectType type, uint64_t handle, const std::string& label) const;

  std::unique_ptr<Instance> m_instance;
  PhysicalDevice m_physical;
  PFN_vkSetDebugUtilsObjectNameEXT m_setName = nullptr;
};

}  // namespace vulkan
