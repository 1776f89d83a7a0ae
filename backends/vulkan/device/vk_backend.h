// The Vulkan backend's factory; the only header of this folder that others include.
// Needs Vulkan 1.3, or 1.2 with VK_KHR_dynamic_rendering and VK_KHR_synchronization2.
#pragma once

#include <memory>

#include "backends/rhi/device.h"

namespace vulkan {

std::unique_ptr<rhi::Backend> makeBackend();

}  // namespace vulkan
