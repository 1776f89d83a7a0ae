// The manifests of drivers that the loader reads, and whether their libraries load. The loader says
// the same for "none is installed" and "none loads"; the second is the usual fault of a container.
#pragma once

#include <string>
#include <vector>

namespace vulkan {

/// One sentence a manifest that is broken, or whose library does not load.
std::vector<std::string> brokenDrivers();

/// Why the loader found no driver.
std::string whyNoDriver();

}  // namespace vulkan
