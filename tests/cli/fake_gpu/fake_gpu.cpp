// A Vulkan layer for tests: the driver below poses as a discrete GPU whose timestamps are those of
// another clock, so that what real counters do happens on every machine.
//   FAKE_BITS    valid bits of a timestamp; 0: the device has none (default 64)
//   FAKE_PERIOD  nanoseconds a tick (default 1); times are the driver's all the same
//   FAKE_SPEED   factor of the times that stamps tell (default 1)
//   FAKE_EVENT   "wrap:N", "reset:N": what happens to the counter in the middle of the N-th reading
//                of two or more stamps, counted from 1; "reset:*": in every one
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace {

/// What the layer calls below itself. Taken while the instance is made: later the loader hands out
/// the top of the chain for the same names.
struct Next {
  PFN_vkGetInstanceProcAddr instanceProc = nullptr;
  PFN_vkGetDeviceProcAddr deviceProc = nullptr;
  PFN_vkGetPhysicalDeviceProperties properties = nullptr;
  PFN_vkGetPhysicalDeviceProperties2 properties2 = nullptr;
  PFN_vkGetPhysicalDeviceQueueFamilyProperties families = nullptr;
  PFN_vkGetPhysicalDeviceQueueFamilyProperties2 families2 = nullptr;
  PFN_vkCreateDevice createDevice = nullptr;
  PFN_vkCreateQueryPool createPool = nullptr;
  PFN_vkGetQueryPoolResults results = nullptr;
} g_next;

std::mutex g_mutex;
std::set<VkQueryPool> g_stamps;
uint64_t g_first = 0;   ///< of the driver's nanoseconds, subtracted so that doubles suffice
uint64_t g_offset = 0;  ///< ticks that events have added
int g_readings = 0;

double number(const char* name, double fallback) {
  const char* text = std::getenv(name);
  return text ? std::atof(text) : fallback;
}
uint32_t bits() { return uint32_t(number("FAKE_BITS", 64)); }
uint64_t mask() { return bits() >= 64 ? UINT64_MAX : (uint64_t(1) << bits()) - 1; }

void pose(VkPhysicalDeviceProperties& p) {
  p.deviceType = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU;
  p.limits.timestampPeriod = float(number("FAKE_PERIOD", 1));
}

VKAPI_ATTR void VKAPI_CALL properties(VkPhysicalDevice device, VkPhysicalDeviceProperties* p) {
  g_next.properties(device, p);
  pose(*p);
}
VKAPI_ATTR void VKAPI_CALL properties2(VkPhysicalDevice device, VkPhysicalDeviceProperties2* p) {
  g_next.properties2(device, p);
  pose(p->properties);
}
VKAPI_ATTR void VKAPI_CALL families(VkPhysicalDevice device, uint32_t* count,
                                    VkQueueFamilyProperties* out) {
  g_next.families(device, count, out);
  for (uint32_t i = 0; out && i < *count; ++i) out[i].timestampValidBits = bits();
}
VKAPI_ATTR void VKAPI_CALL families2(VkPhysicalDevice device, uint32_t* count,
                                     VkQueueFamilyProperties2* out) {
  g_next.families2(device, count, out);
  for (uint32_t i = 0; out && i < *count; ++i)
    out[i].queueFamilyProperties.timestampValidBits = bits();
}

VKAPI_ATTR VkResult VKAPI_CALL createPool(VkDevice device, const VkQueryPoolCreateInfo* info,
                                          const VkAllocationCallbacks* allocator,
                                          VkQueryPool* pool) {
  const VkResult result = g_next.createPool(device, info, allocator, pool);
  const std::lock_guard lock(g_mutex);
  if (result == VK_SUCCESS && info->queryType == VK_QUERY_TYPE_TIMESTAMP) g_stamps.insert(*pool);
  return result;
}

/// Does the event of that kind happen in the reading under way?
bool happens(const std::string& kind) {
  const char* event = std::getenv("FAKE_EVENT");
  if (!event) return false;
  const std::string text = event;
  return text == kind + ":*" || text == kind + ":" + std::to_string(g_readings);
}

/// The driver's nanoseconds become ticks of the counter that the layer plays.
void disguise(std::vector<uint64_t*>& stamps) {
  const std::lock_guard lock(g_mutex);
  if (g_first == 0) g_first = *stamps.front();
  const double ticksPerNs = number("FAKE_SPEED", 1) / number("FAKE_PERIOD", 1);
  for (uint64_t* s : stamps) *s = uint64_t(std::llround(double(*s - g_first) * ticksPerNs));
  if (stamps.size() > 1) ++g_readings;
  const uint64_t middle = *stamps.front() + (*stamps.back() - *stamps.front()) / 2;
  if (stamps.size() > 1 && happens("wrap")) g_offset = mask() - middle;
  const bool reset = stamps.size() > 1 && happens("reset");
  for (uint64_t* s : stamps) *s = (reset && *s > middle ? *s - middle : *s + g_offset) & mask();
  if (reset) g_offset = uint64_t(0) - middle;
}

VKAPI_ATTR VkResult VKAPI_CALL results(VkDevice device, VkQueryPool pool, uint32_t first,
                                       uint32_t count, size_t size, void* data, VkDeviceSize stride,
                                       VkQueryResultFlags flags) {
  const VkResult result = g_next.results(device, pool, first, count, size, data, stride, flags);
  if (result != VK_SUCCESS || !g_stamps.contains(pool)) return result;
  std::vector<uint64_t*> stamps;
  for (uint32_t i = 0; i < count; ++i)
    stamps.push_back(reinterpret_cast<uint64_t*>(static_cast<char*>(data) + i * stride));
  disguise(stamps);
  return result;
}

template <class Info>
Info* linkOf(const void* chain, VkStructureType type) {
  for (auto* i = static_cast<const Info*>(chain); i; i = static_cast<const Info*>(i->pNext))
    if (i->sType == type && i->function == VK_LAYER_LINK_INFO) return const_cast<Info*>(i);
  return nullptr;
}

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info,
                                              const VkAllocationCallbacks* allocator,
                                              VkInstance* instance) {
  auto* link =
      linkOf<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
  if (!link) return VK_ERROR_INITIALIZATION_FAILED;
  g_next.instanceProc = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  const auto create = reinterpret_cast<PFN_vkCreateInstance>(
      g_next.instanceProc(VK_NULL_HANDLE, "vkCreateInstance"));
  const VkResult result = create(info, allocator, instance);
  if (result != VK_SUCCESS) return result;
  const auto take = [&]<class F>(F& function, const char* name) {
    function = reinterpret_cast<F>(g_next.instanceProc(*instance, name));
  };
  take(g_next.properties, "vkGetPhysicalDeviceProperties");
  take(g_next.properties2, "vkGetPhysicalDeviceProperties2");
  take(g_next.families, "vkGetPhysicalDeviceQueueFamilyProperties");
  take(g_next.families2, "vkGetPhysicalDeviceQueueFamilyProperties2");
  take(g_next.createDevice, "vkCreateDevice");
  return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical,
                                            const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator,
                                            VkDevice* device) {
  auto* link =
      linkOf<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
  if (!link) return VK_ERROR_INITIALIZATION_FAILED;
  g_next.deviceProc = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  const VkResult result = g_next.createDevice(physical, info, allocator, device);
  if (result != VK_SUCCESS) return result;
  g_next.createPool =
      reinterpret_cast<PFN_vkCreateQueryPool>(g_next.deviceProc(*device, "vkCreateQueryPool"));
  g_next.results = reinterpret_cast<PFN_vkGetQueryPoolResults>(
      g_next.deviceProc(*device, "vkGetQueryPoolResults"));
  return result;
}

}  // namespace

extern "C" {

VK_LAYER_EXPORT PFN_vkVoidFunction fakeDeviceProc(VkDevice device, const char* name) {
  if (!std::strcmp(name, "vkGetDeviceProcAddr"))
    return reinterpret_cast<PFN_vkVoidFunction>(fakeDeviceProc);
  if (!std::strcmp(name, "vkCreateQueryPool"))
    return reinterpret_cast<PFN_vkVoidFunction>(createPool);
  if (!std::strcmp(name, "vkGetQueryPoolResults"))
    return reinterpret_cast<PFN_vkVoidFunction>(results);
  return g_next.deviceProc(device, name);
}

VK_LAYER_EXPORT PFN_vkVoidFunction fakeInstanceProc(VkInstance instance, const char* name) {
  static const struct {
    const char* name;
    PFN_vkVoidFunction function;
  } kOurs[] = {
      {"vkGetInstanceProcAddr", reinterpret_cast<PFN_vkVoidFunction>(fakeInstanceProc)},
      {"vkGetDeviceProcAddr", reinterpret_cast<PFN_vkVoidFunction>(fakeDeviceProc)},
      {"vkCreateInstance", reinterpret_cast<PFN_vkVoidFunction>(createInstance)},
      {"vkCreateDevice", reinterpret_cast<PFN_vkVoidFunction>(createDevice)},
      {"vkGetPhysicalDeviceProperties", reinterpret_cast<PFN_vkVoidFunction>(properties)},
      {"vkGetPhysicalDeviceProperties2", reinterpret_cast<PFN_vkVoidFunction>(properties2)},
      {"vkGetPhysicalDeviceProperties2KHR", reinterpret_cast<PFN_vkVoidFunction>(properties2)},
      {"vkGetPhysicalDeviceQueueFamilyProperties", reinterpret_cast<PFN_vkVoidFunction>(families)},
      {"vkGetPhysicalDeviceQueueFamilyProperties2",
       reinterpret_cast<PFN_vkVoidFunction>(families2)},
      {"vkGetPhysicalDeviceQueueFamilyProperties2KHR",
       reinterpret_cast<PFN_vkVoidFunction>(families2)},
  };
  for (const auto& ours : kOurs)
    if (!std::strcmp(name, ours.name)) return ours.function;
  return g_next.instanceProc ? g_next.instanceProc(instance, name) : nullptr;
}

}  // extern "C"
