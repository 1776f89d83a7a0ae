#include "backends/vulkan/device/vk_device_info.h"

#include <algorithm>
#include <set>

namespace vulkan {

VkPhysicalDeviceFeatures2* FeatureChain::link(bool core13, bool withInterlock) {
  core.pNext = &v11;
  v11.pNext = &v12;
  void* tail = withInterlock ? &interlock : nullptr;
  interlock.pNext = nullptr;
  if (core13) {
    v12.pNext = &v13;
    v13.pNext = tail;
  } else {
    v12.pNext = &rendering;
    rendering.pNext = &synchronization;
    synchronization.pNext = tail;
  }
  return &core;
}

namespace {

std::set<std::string> extensionsOf(VkPhysicalDevice device) {
  uint32_t count = 0;
  vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> list(count);
  vkEnumerateDeviceExtensionProperties(device, nullptr, &count, list.data());
  std::set<std::string> names;
  for (const auto& e : list) names.insert(e.extensionName);
  return names;
}

std::string versionText(uint32_t v) {
  return std::to_string(VK_API_VERSION_MAJOR(v)) + "." + std::to_string(VK_API_VERSION_MINOR(v)) +
         "." + std::to_string(VK_API_VERSION_PATCH(v));
}

rhi::DeviceType typeOf(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return rhi::DeviceType::Discrete;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return rhi::DeviceType::Integrated;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return rhi::DeviceType::Virtual;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return rhi::DeviceType::Software;
    default:
      return rhi::DeviceType::Other;
  }
}

/// Keeps of `have` what the backend uses; missing essentials are appended to `missing`.
FeatureChain choose(const FeatureChain& have, bool core13, std::string& missing) {
  auto require = [&](bool present, const char* name) {
    if (!present) missing += (missing.empty() ? "" : ", ") + std::string(name);
  };
  FeatureChain want;
  want.core.features = have.core.features;
  // Bounds checks and sparse memory change what a frame costs and are never asked for.
  VkPhysicalDeviceFeatures& core = want.core.features;
  core.robustBufferAccess = VK_FALSE;
  core.sparseBinding = core.sparseResidencyBuffer = core.sparseResidencyImage2D = VK_FALSE;
  core.sparseResidencyImage3D = core.sparseResidency2Samples = VK_FALSE;
  core.sparseResidency4Samples = core.sparseResidency8Samples = VK_FALSE;
  core.sparseResidency16Samples = core.sparseResidencyAliased = VK_FALSE;
  want.v11.shaderDrawParameters = have.v11.shaderDrawParameters;
  want.v12.shaderOutputLayer = have.v12.shaderOutputLayer;
  want.v12.shaderOutputViewportIndex = have.v12.shaderOutputViewportIndex;
  want.v12.scalarBlockLayout = have.v12.scalarBlockLayout;
  want.v12.timelineSemaphore = VK_TRUE;
  want.v12.hostQueryReset = VK_TRUE;
  require(have.v12.timelineSemaphore, "timelineSemaphore");
  require(have.v12.hostQueryReset, "hostQueryReset");
  if (core13) {
    want.v13.dynamicRendering = want.v13.synchronization2 = VK_TRUE;
    want.v13.maintenance4 = have.v13.maintenance4;
    want.v13.shaderDemoteToHelperInvocation = have.v13.shaderDemoteToHelperInvocation;
    want.v13.shaderTerminateInvocation = have.v13.shaderTerminateInvocation;
    require(have.v13.dynamicRendering, "dynamicRendering");
    require(have.v13.synchronization2, "synchronization2");
  } else {
    want.rendering.dynamicRendering = want.synchronization.synchronization2 = VK_TRUE;
    require(have.rendering.dynamicRendering, "VK_KHR_dynamic_rendering");
    require(have.synchronization.synchronization2, "VK_KHR_synchronization2");
  }
  want.interlock = have.interlock;
  return want;
}

// Anisotropy, conservative rasterization, depth bounds and ray queries are left out: the interface
// has no state that would use them.
std::set<rhi::Feature> featuresOf(const PhysicalDevice& device) {
  using F = rhi::Feature;
  const VkPhysicalDeviceFeatures& core = device.features.core.features;
  std::set<F> out;
  auto add = [&](F feature, bool present) {
    if (present) out.insert(feature);
  };
  add(F::DepthClamp, core.depthClamp);
  add(F::GeometryShader, core.geometryShader);
  add(F::VertexLayer, device.features.v12.shaderOutputLayer);
  add(F::SampleRateShading, core.sampleRateShading);
  add(F::DualSourceBlend, core.dualSrcBlend);
  add(F::IndependentBlend, core.independentBlend);
  add(F::LogicOp, core.logicOp);
  add(F::FragmentStoresAndAtomics, core.fragmentStoresAndAtomics);
  add(F::PipelineStatistics, core.pipelineStatisticsQuery);
  add(F::PreciseOcclusion, core.occlusionQueryPrecise);
  add(F::MultiDrawIndirect, core.multiDrawIndirect);
  add(F::FragmentInterlock, device.withInterlock &&
                                device.features.interlock.fragmentShaderPixelInterlock &&
                                device.features.interlock.fragmentShaderSampleInterlock);
  return out;
}

rhi::Limits limitsOf(const PhysicalDevice& device, uint32_t timestampBits) {
  const VkPhysicalDeviceLimits& l = device.properties.limits;
  const bool geometry = device.features.core.features.geometryShader;
  rhi::Limits out = {
      .maxTexture2D = l.maxImageDimension2D,
      .maxTexture3D = l.maxImageDimension3D,
      .maxTextureLayers = l.maxImageArrayLayers,
      .maxColorAttachments = std::min(l.maxColorAttachments, rhi::kMaxColorAttachments),
      .maxStorageRange = l.maxStorageBufferRange,
      .maxUniformRange = l.maxUniformBufferRange,
      .uniformAlignment = uint32_t(l.minUniformBufferOffsetAlignment),
      .storageAlignment = uint32_t(l.minStorageBufferOffsetAlignment),
      .subPixelBits = l.subPixelPrecisionBits,
      .maxGeometryVertices = geometry ? l.maxGeometryOutputVertices : 0,
      .maxComputeInvocations = l.maxComputeWorkGroupInvocations,
      .timestampPeriodNs = l.timestampPeriod,
      .timestampBits = timestampBits,
  };
  const VkSampleCountFlags counts = l.framebufferColorSampleCounts & l.framebufferDepthSampleCounts;
  for (uint32_t samples = 1; samples <= 64; samples *= 2)
    if (counts & samples) out.sampleCounts.push_back(samples);
  return out;
}

/// Picks the first family that does graphics and compute; appends to `missing` if there is none.
void chooseQueue(PhysicalDevice& device, std::string& missing, uint32_t& timestampBits) {
  uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device.handle, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device.handle, &count, families.data());
  constexpr VkQueueFlags kBoth = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  for (uint32_t i = 0; i < count; ++i)
    if ((families[i].queueFlags & kBoth) == kBoth) {
      device.queueFamily = i;
      timestampBits = families[i].timestampValidBits;
      return;
    }
  missing += (missing.empty() ? "" : ", ") + std::string("a queue for graphics and compute");
}

PhysicalDevice describe(VkPhysicalDevice handle, uint32_t index) {
  PhysicalDevice d;
  d.handle = handle;
  VkPhysicalDeviceDriverProperties driver = {
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
  VkPhysicalDeviceProperties2 properties = {.sType =
                                                VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
  vkGetPhysicalDeviceProperties(handle, &d.properties);
  d.info.backend = "vulkan";
  d.info.index = index;
  d.info.name = d.properties.deviceName;
  d.info.type = typeOf(d.properties.deviceType);
  d.info.apiVersion = versionText(d.properties.apiVersion);
  if (d.properties.apiVersion < VK_API_VERSION_1_2) {
    d.info.unusable = "Vulkan 1.2 is needed, it has " + d.info.apiVersion;
    return d;
  }
  properties.pNext = &driver;
  vkGetPhysicalDeviceProperties2(handle, &properties);
  d.isLavapipe = driver.driverID == VK_DRIVER_ID_MESA_LLVMPIPE;
  d.info.driver = driver.driverName;
  d.info.driverVersion = driver.driverInfo;

  vkGetPhysicalDeviceMemoryProperties(handle, &d.memory);
  for (uint32_t i = 0; i < d.memory.memoryHeapCount; ++i)
    if (d.memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
      d.info.memoryBytes += d.memory.memoryHeaps[i].size;

  const std::set<std::string> extensions = extensionsOf(handle);
  d.core13 = d.properties.apiVersion >= VK_API_VERSION_1_3 &&
             volkGetInstanceVersion() >= VK_API_VERSION_1_3;
  d.withInterlock = extensions.contains(VK_EXT_FRAGMENT_SHADER_INTERLOCK_EXTENSION_NAME);
  if (d.withInterlock) d.extensions.push_back(VK_EXT_FRAGMENT_SHADER_INTERLOCK_EXTENSION_NAME);
  std::string missing;
  bool queryable = true;
  if (!d.core13)
    for (const char* name :
         {VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME, VK_KHR_SYNCHRONIZATION_2_EXTENSION_NAME}) {
      if (extensions.contains(name)) {
        d.extensions.push_back(name);
      } else {
        missing += (missing.empty() ? "" : ", ") + std::string(name);
        queryable = false;
      }
    }
  if (queryable) {
    FeatureChain have;
    vkGetPhysicalDeviceFeatures2(handle, have.link(d.core13, d.withInterlock));
    d.features = choose(have, d.core13, missing);
  }
  uint32_t timestampBits = 0;
  chooseQueue(d, missing, timestampBits);
  if (d.properties.limits.maxDescriptorSetUniformBuffersDynamic < rhi::kStorageSlotBase)
    missing += (missing.empty() ? "" : ", ") + std::string("8 dynamic uniform buffers");
  d.info.features = featuresOf(d);
  d.info.limits = limitsOf(d, timestampBits);
  if (!missing.empty()) d.info.unusable = "missing " + missing;
  return d;
}

}  // namespace

std::vector<PhysicalDevice> describeDevices(const Instance& instance) {
  uint32_t count = 0;
  check(vkEnumeratePhysicalDevices(instance.handle(), &count, nullptr),
        "vkEnumeratePhysicalDevices");
  std::vector<VkPhysicalDevice> handles(count);
  check(vkEnumeratePhysicalDevices(instance.handle(), &count, handles.data()),
        "vkEnumeratePhysicalDevices");
  if (count == 0) throw rhi::Error("vkEnumeratePhysicalDevices", "", "no Vulkan driver was found");
  std::vector<PhysicalDevice> out;
  for (uint32_t i = 0; i < count; ++i) out.push_back(describe(handles[i], i));
  return out;
}

}  // namespace vulkan
