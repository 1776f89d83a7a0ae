#include "backends/vulkan/device/vk_context.h"

namespace vulkan {

Context::Context(std::unique_ptr<Instance> instance, const PhysicalDevice& physical)
    : m_instance(std::move(instance)), m_physical(physical) {
  const float priority = 1;
  const VkDeviceQueueCreateInfo queueInfo = {
      .sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
      .queueFamilyIndex = m_physical.queueFamily,
      .queueCount = 1,
      .pQueuePriorities = &priority,
  };
  const VkDeviceCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
      .pNext = m_physical.features.link(m_physical.core13, m_physical.withInterlock),
      .queueCreateInfoCount = 1,
      .pQueueCreateInfos = &queueInfo,
      .enabledExtensionCount = uint32_t(m_physical.extensions.size()),
      .ppEnabledExtensionNames = m_physical.extensions.data(),
  };
  check(vkCreateDevice(m_physical.handle, &info, nullptr, &device), "vkCreateDevice",
        m_physical.info.name);
  volkLoadDeviceTable(&vk, device);
  if (!m_physical.core13) {
    vk.vkCmdBeginRendering = vk.vkCmdBeginRenderingKHR;
    vk.vkCmdEndRendering = vk.vkCmdEndRenderingKHR;
    vk.vkCmdPipelineBarrier2 = vk.vkCmdPipelineBarrier2KHR;
    vk.vkCmdWriteTimestamp2 = vk.vkCmdWriteTimestamp2KHR;
    vk.vkQueueSubmit2 = vk.vkQueueSubmit2KHR;
  }
  if (m_instance->debugUtils()) {
    auto load = [&](const char* name) { return vkGetDeviceProcAddr(device, name); };
    m_setName = PFN_vkSetDebugUtilsObjectNameEXT(load("vkSetDebugUtilsObjectNameEXT"));
    cmdBeginLabel = PFN_vkCmdBeginDebugUtilsLabelEXT(load("vkCmdBeginDebugUtilsLabelEXT"));
    cmdEndLabel = PFN_vkCmdEndDebugUtilsLabelEXT(load("vkCmdEndDebugUtilsLabelEXT"));
  }
  vk.vkGetDeviceQueue(device, m_physical.queueFamily, 0, &queue);
  const VkPipelineCacheCreateInfo cacheInfo = {.sType =
                                                   VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
  check(vk.vkCreatePipelineCache(device, &cacheInfo, nullptr, &pipelineCache),
        "vkCreatePipelineCache");
}

Context::~Context() {
  vk.vkDestroyPipelineCache(device, pipelineCache, nullptr);
  vk.vkDestroyDevice(device, nullptr);
}

void Context::setName(VkObjectType type, uint64_t handle, const std::string& label) const {
  if (!m_setName || label.empty()) return;
  const VkDebugUtilsObjectNameInfoEXT info = {
      .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
      .objectType = type,
      .objectHandle = handle,
      .pObjectName = label.c_str(),
  };
  m_setName(device, &info);
}

}  // namespace vulkan
