// What the physical devices of an instance are and can do, and which features and extensions a
// device is opened with. Decides by query only.
#pragma once

#include <vector>

#include "backends/rhi/device_info.h"
#include "backends/vulkan/device/vk_instance.h"

namespace vulkan {

/// The feature structs of a query or a creation; `link` chains them in place.
struct FeatureChain {
  VkPhysicalDeviceFeatures2 core = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  VkPhysicalDeviceVulkan11Features v11 = {
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES};
  VkPhysicalDeviceVulkan12Features v12 = {
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  VkPhysicalDeviceVulkan13Features v13 = {
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  VkPhysicalDeviceDynamicRenderingFeatures rendering = {
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_FEATURES};
  VkPhysicalDeviceSynchronization2Features synchronization = {
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SYNCHRONIZATION_2_FEATURES};
  VkPhysicalDeviceFragmentShaderInterlockFeaturesEXT interlock = {
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAGMENT_SHADER_INTERLOCK_FEATURES_EXT};

  VkPhysicalDeviceFeatures2* link(bool core13, bool withInterlock);
};

struct PhysicalDevice {
  VkPhysicalDevice handle = VK_NULL_HANDLE;
  VkPhysicalDeviceProperties properties = {};
  VkPhysicalDeviceMemoryProperties memory = {};
  rhi::DeviceInfo info;
  uint32_t queueFamily = 0;
  bool core13 = false;  ///< else dynamic rendering and synchronization2 are extensions
  bool withInterlock = false;
  bool isLavapipe = false;  ///< Mesa's software driver
  FeatureChain features;  ///< to be enabled, not linked
  std::vector<const char*> extensions;
};

/// Never empty: throws rhi::Error when there is no driver.
std::vector<PhysicalDevice> describeDevices(const Instance& instance);

}  // namespace vulkan
