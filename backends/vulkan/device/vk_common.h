// What every file of this backend needs: the Vulkan types (through volk, so that a machine without
// a loader is a runtime answer, not a link failure) and the check that turns VkResult into
// rhi::Error.
#pragma once

#define VK_NO_PROTOTYPES
#include <volk.h>

#include <source_location>
#include <string>
#include <string_view>

#include "backends/rhi/error.h"

namespace vulkan {

/// "VK_ERROR_DEVICE_LOST" and so on; numbers for codes this backend has no name for.
std::string resultName(VkResult result);

[[noreturn]] void fail(VkResult result, const char* call, std::string_view detail,
                       std::source_location where);

/// Throws rhi::Error for anything but VK_SUCCESS.
inline void check(VkResult result, const char* call, std::string_view detail = {},
                  std::source_location where = std::source_location::current()) {
  if (result != VK_SUCCESS) [[unlikely]]
    fail(result, call, detail, where);
}

}  // namespace vulkan
