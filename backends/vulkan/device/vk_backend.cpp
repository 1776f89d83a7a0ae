#include "backends/vulkan/device/vk_backend.h"

#include "backends/vulkan/device/vk_device.h"
#include "backends/vulkan/device/vk_device_info.h"
#include "backends/vulkan/device/vk_drivers.h"
#include "backends/vulkan/device/vk_instance.h"

namespace vulkan {
namespace {

class Backend final : public rhi::Backend {
 public:
  std::string_view name() const override { return "vulkan"; }

  std::vector<rhi::DeviceInfo> enumerate() override {
    Instance instance(false);
    return infos(describeDevices(instance));
  }

  std::vector<std::string> troubles() override { return brokenDrivers(); }

  std::unique_ptr<rhi::Device> open(const rhi::DeviceRequest& request) override {
    auto instance = std::make_unique<Instance>(request.validate);
    std::vector<PhysicalDevice> devices = describeDevices(*instance);
    const size_t chosen = rhi::chooseDevice(infos(devices), request.selector);
    return std::make_unique<Device>(std::move(instance), devices[chosen]);
  }

 private:
  static std::vector<rhi::DeviceInfo> infos(const std::vector<PhysicalDevice>& devices) {
    std::vector<rhi::DeviceInfo> out;
    for (const PhysicalDevice& device : devices) out.push_back(device.info);
    return out;
  }
};

}  // namespace

std::unique_ptr<rhi::Backend> makeBackend() { return std::make_unique<Backend>(); }

}  // namespace vulkan
