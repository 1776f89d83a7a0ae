#define VOLK_IMPLEMENTATION
#include "backends/vulkan/device/vk_instance.h"

#include "backends/vulkan/device/vk_drivers.h"

#include <algorithm>
#include <vector>

namespace vulkan {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

bool hasExtension(const char* layer, std::string_view name) {
  uint32_t count = 0;
  vkEnumerateInstanceExtensionProperties(layer, &count, nullptr);
  std::vector<VkExtensionProperties> list(count);
  vkEnumerateInstanceExtensionProperties(layer, &count, list.data());
  return std::ranges::any_of(list, [&](const auto& e) { return e.extensionName == name; });
}

void requireValidation() {
  uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  if (std::ranges::none_of(
          layers, [](const auto& l) { return l.layerName == std::string_view(kValidationLayer); }))
    throw rhi::Error(
        "vkCreateInstance", "VK_ERROR_LAYER_NOT_PRESENT",
        std::string("validation was asked for, but ") + kValidationLayer + " is not installed");
  if (!hasExtension(kValidationLayer, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME))
    throw rhi::Error("vkCreateInstance", "VK_ERROR_EXTENSION_NOT_PRESENT",
                     "this validation layer cannot check synchronization");
}

}  // namespace

Instance::Instance(bool validate) : m_validate(validate) {
  if (volkInitialize() != VK_SUCCESS)
    throw rhi::Error("vulkan loader", "", "no Vulkan loader (libvulkan.so.1) on this machine");
  const uint32_t loader = volkGetInstanceVersion();
  if (loader < VK_API_VERSION_1_2)
    throw rhi::Error("vulkan loader", "", "the Vulkan loader is older than 1.2");
  if (validate) requireValidation();

  std::vector<const char*> layers, extensions;
  m_debugUtils = hasExtension(nullptr, VK_EXT_DEBUG_UTILS_EXTENSION_NAME) ||
                 (validate && hasExtension(kValidationLayer, VK_EXT_DEBUG_UTILS_EXTENSION_NAME));
  if (m_debugUtils) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  const VkValidationFeatureEnableEXT enables[] = {
      VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  const VkValidationFeaturesEXT features = {
      .sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
      .enabledValidationFeatureCount = 1,
      .pEnabledValidationFeatures = enables,
  };
  if (validate) {
    layers.push_back(kValidationLayer);
    extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
  }

  const VkApplicationInfo application = {
      .sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
      .pApplicationName = "ShadowBench",
      .apiVersion = std::min(loader, uint32_t(VK_API_VERSION_1_3)),
  };
  const VkInstanceCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
      .pNext = validate ? &features : nullptr,
      .pApplicationInfo = &application,
      .enabledLayerCount = uint32_t(layers.size()),
      .ppEnabledLayerNames = layers.data(),
      .enabledExtensionCount = uint32_t(extensions.size()),
      .ppEnabledExtensionNames = extensions.data(),
  };
  const VkResult result = vkCreateInstance(&info, nullptr, &m_instance);
  if (result == VK_ERROR_INCOMPATIBLE_DRIVER)
    check(result, "vkCreateInstance", whyNoDriver());
  check(result, "vkCreateInstance");
  // Instance-level pointers are the loader's trampolines: several instances can share them.
  volkLoadInstanceOnly(m_instance);
}

Instance::~Instance() {
  if (m_instance) vkDestroyInstance(m_instance, nullptr);
}

}  // namespace vulkan
