#include "backends/vulkan/device/vk_debug.h"

namespace vulkan {
namespace {

VKAPI_ATTR VkBool32 VKAPI_CALL onMessage(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                         VkDebugUtilsMessageTypeFlagsEXT,
                                         const VkDebugUtilsMessengerCallbackDataEXT* data,
                                         void* user) {
  static_cast<rhi::Device*>(user)->report(
      {"vulkan", data->pMessageIdName ? data->pMessageIdName : "", data->pMessage});
  return VK_FALSE;
}

}  // namespace

Messenger::Messenger(const Instance& instance, rhi::Device& sink) {
  if (!instance.validates() || !instance.debugUtils()) return;
  auto create = PFN_vkCreateDebugUtilsMessengerEXT(
      vkGetInstanceProcAddr(instance.handle(), "vkCreateDebugUtilsMessengerEXT"));
  // Not the loader's general chatter, and not performance hints: those are no defects.
  const VkDebugUtilsMessengerCreateInfoEXT info = {
      .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
      .messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                         VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
      .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT,
      .pfnUserCallback = onMessage,
      .pUserData = &sink,
  };
  check(create(instance.handle(), &info, nullptr, &m_messenger), "vkCreateDebugUtilsMessengerEXT");
  m_instance = instance.handle();
}

Messenger::~Messenger() {
  if (!m_messenger) return;
  auto destroy = PFN_vkDestroyDebugUtilsMessengerEXT(
      vkGetInstanceProcAddr(m_instance, "vkDestroyDebugUtilsMessengerEXT"));
  destroy(m_instance, m_messenger, nullptr);
}

}  // namespace vulkan
